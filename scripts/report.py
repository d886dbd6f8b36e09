#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes one page of HTML, to hand on, of what a run left in a folder (doc/guides/report.md).

Usage: report.py DIR --output FILE.html (through `lamella report`, which finds a fitting
python3 and says in --program what its library of materials has)
"""

import sys

from lamella_report.command import main

if __name__ == "__main__":
    sys.exit(main())
