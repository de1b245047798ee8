"""read_vtk - VTK: vtkPLYReader

SPDX-License-Identifier: MIT
"""
import os
import sys

import vtk

for path in sys.argv[1:]:
    reader = vtk.vtkPLYReader()
    reader.SetFileName(path)
    reader.Update()
    data = reader.GetOutput()
    print(os.path.basename(path), data.GetNumberOfPolys(), data.GetNumberOfPoints())
