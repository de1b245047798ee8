"""shapes_made - the shapes of a folder, for the writers in Python

SPDX-License-Identifier: MIT
"""
import glob
import json
import os
import sys


def shapes():
    """Every shape of the folder that is argv[1], and its file's stem in folder argv[2]."""
    for path in sorted(glob.glob(os.path.join(sys.argv[1], "*.json"))):
        with open(path) as file:
            made = json.load(file)
        yield made, os.path.join(sys.argv[2], made["name"])
