#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Installs Lamella into a scratch prefix, builds step-0 on it in a folder that
knows nothing of the source tree, and runs it. The installed program runs a scene and makes
a report of it with the templates that were installed.

Usage: check_install.py ROOT BUILD WORKDIR [DEAL_II_DIR]
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path


def run(*words, **options):
    done = subprocess.run(words, capture_output=True, text=True, **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(words)}\nends with {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def check_report(program, prefix, scene, output):
    run(program, str(scene), "--output", str(output))
    template, = prefix.rglob("lamella_report/templates/glance.html")
    template.write_text(template.read_text() + "<p>A template that a user has edited.</p>\n")
    run(program, "report", str(output))
    page = (output / "report.html").read_text()
    for words in ("A template that a user has edited.", "data:image/png;base64,"):
        if words not in page:
            sys.exit(f"the report of the installed program lacks: {words}")


def main(root, build, workdir, deal_ii=""):
    shutil.rmtree(workdir, ignore_errors=True)
    prefix, project = workdir / "prefix", workdir / "project"
    project.mkdir(parents=True)
    run("cmake", "--install", str(build), "--prefix", str(prefix))
    shutil.copy(root / "tests/install/CMakeLists.txt", project)
    shutil.copy(root / "tutorials/step-0/step-0.cc", project)
    packages = list(prefix.rglob("cmake/Lamella/*.cmake"))
    if not packages:
        sys.exit(f"nothing for find_package() in {prefix}")
    for path in packages:
        if str(root) in path.read_text():
            sys.exit(f"{path} names the source tree")

    words = ["cmake", "-G", "Ninja", "-S", str(project), "-B", str(project / "build"),
             f"-DCMAKE_PREFIX_PATH={prefix}"]
    if deal_ii:
        words.append(f"-DDEAL_II_DIR={deal_ii}")
    run(*words)
    run("cmake", "--build", str(project / "build"))

    # It is the tutorial: the same numbers are pinned.
    print(run(sys.executable, str(root / "tests/tutorials/check_tutorial.py"),
              str(project / "build/step-0"), str(root / "tutorials/step-0/step-0.expect")))
    program = str(prefix / "bin/lamella")
    version = run(program, "--version", env={**os.environ, "OPENBLAS_NUM_THREADS": "1"})
    if not version.startswith("lamella "):
        sys.exit(f"the installed program says: {version}")
    listed = run(program, "--list-diagnostics")
    if "\nsolve.no-equilibrium\tfailure\tNo stable equilibrium" not in listed:
        sys.exit(f"the installed program lists: {listed[:200]}")
    check_report(program, prefix, root / "tests/report/loads.prm", workdir / "run")
    shutil.rmtree(workdir)
    print("A program outside of the tree builds on what was installed.")


if __name__ == "__main__":
    if len(sys.argv) not in (4, 5):
        sys.exit(__doc__)
    main(*(Path(argument).resolve() for argument in sys.argv[1:4]), *sys.argv[4:])
