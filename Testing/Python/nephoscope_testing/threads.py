# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a module of tests makes with several numbers of threads. The number is fixed when VTK starts: each runs by itself."""
import os
import subprocess
import sys


def results(module_file, expression):
    """The different values that the expression, as the module's own code sees it, prints with 1, 2 and 5 threads."""
    folder, name = os.path.split(os.path.abspath(module_file))
    code = f"import {os.path.splitext(name)[0]} as tested; print(eval({expression!r}, vars(tested)))"
    return {subprocess.check_output([sys.executable, "-c", code], cwd=folder, env=dict(os.environ, VTK_SMP_MAX_THREADS=threads))
            for threads in ("1", "2", "5")}
