// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// `var`, because Sphinx declares it so in searchtools.js too.
// The weights of the search: pages whose title or text has the word come before members of the reference that have it in their name.
var Scorer = {
  objNameMatch: 11,
  objPartialMatch: 1,
  objPrio: { 0: 4, 1: 0, 2: -5 },
  objPrioDefault: 0,
  title: 25,
  partialTitle: 17,
  term: 8,
  partialTerm: 2,
};
