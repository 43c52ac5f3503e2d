# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests share: a per-ray reference renderer in numpy, meshes, off-screen scenes, image comparison."""
