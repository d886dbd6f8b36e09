#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What scripts/peers.py says where CalculiX is missing or fails.

Usage: check_peers.py LAMELLA SCENE.prm WORKDIR

Needs no CalculiX: it is played by small scripts.
"""

import os
import subprocess
import sys
from pathlib import Path

PEERS = Path(__file__).resolve().parent.parent.parent / "scripts" / "peers.py"


def check(condition, what):
    if not condition:
        sys.exit(f"FAIL: {what}")
    print(f"ok: {what}")


def peers(program, scene, path, *words):
    return subprocess.run(
        [sys.executable, PEERS, scene, *words], capture_output=True, text=True,
        env={**os.environ, "PATH": path, "LAMELLA_BUILD": str(program.parent)})


def play(folder, script):
    (folder / "ccx").write_text("#!/bin/sh\n" + script)
    (folder / "ccx").chmod(0o755)


PULLING = """
 contact stress (slave element+face,press,tang1,tang2) for all contact elements and time %s

        37          1 %s  0.000000E+00  0.000000E+00
        37          1  1.145100E+07  0.000000E+00  0.000000E+00

 total force (fx,fy,fz) for set SUPPORT1_X and time  0.1000000E+01

        0.000000E+00  0.100000-101  1.720455E+02
"""


def check_tables(folder):
    """What is read of a .dat, and that surfaces which pull are told."""
    sys.path.insert(0, str(PEERS.parent))
    import peers as module
    dat = folder / "deck.dat"
    for pressure, pulls in (("-0.743900E+09", True), ("-0.500000E+06", False)):
        # The last table of a kind is the one that counts.
        dat.write_text(PULLING % ("0.5000000E+00", "-0.900000E+09") +
                       PULLING % ("0.1000000E+01", pressure))
        tables = module.read_dat(dat)
        check(tables["total", "SUPPORT1_X"] == (1., [[0., 1e-102, 172.0455]]),
              "the total of a set, with an exponent of three digits")
        check(tables["contact", None][0] == 1. and
              bool(module.contact_that_pulls(tables)) == pulls,
              f"a contact pressure of {pressure}")


def main(program, scene, folder):
    folder.mkdir(parents=True, exist_ok=True)
    check_tables(folder)
    (folder / "ccx").unlink(missing_ok=True)
    done = peers(program, scene, str(folder))
    check(done.returncode == 1 and "apt-get install calculix-ccx" in done.stderr,
          f"no ccx: {done.stderr.strip()}")

    # Open MPI looks for programs of its own.
    path = str(folder) + os.pathsep + os.environ["PATH"]
    play(folder, "exit 0\n")
    done = peers(program, scene, path, "--set", "Section upper/Breadth=1")
    check(done.returncode == 1 and "Breadth" in done.stderr,
          "a fault of the scene is told as Lamella tells it")
    done = peers(program, scene, path, "--element", "C3D4")
    check(done.returncode == 1 and "--element C3D4" in done.stderr,
          "and so is one of the export")
    done = peers(program, scene, path)
    check(done.returncode == 2 and "before the end of step 1" in done.stderr,
          f"no results: {done.stderr.strip()}")

    play(folder, "echo '*ERROR in nonlingeo: too many cutbacks'\n"
                 "echo ' best solution and residuals are in the frd file'\nexit 201\n")
    done = peers(program, scene, path)
    check(done.returncode == 2 and "too many cutbacks" in done.stderr,
          f"an error: {done.stderr.strip()}")

    play(folder, "exit 201\n")
    done = peers(program, scene, path)
    check(done.returncode == 2 and "did not converge" in done.stderr,
          f"a failure: {done.stderr.strip()}")


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit("Usage: check_peers.py LAMELLA SCENE.prm WORKDIR")
    main(Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve(),
         Path(sys.argv[3]).resolve())
