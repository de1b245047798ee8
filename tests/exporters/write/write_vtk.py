"""write_vtk - VTK: vtkPLYWriter, vtkSTLWriter, vtkOBJWriter; polygons stay whole

SPDX-License-Identifier: MIT
"""
import vtk

from shapes_made import shapes


def poly_data(made):
    points = vtk.vtkPoints()
    points.SetDataTypeToDouble()
    for position in made["positions"]:
        points.InsertNextPoint(position)
    cells = vtk.vtkCellArray()
    for polygon in made["polygons"]:
        cells.InsertNextCell(len(polygon), polygon)
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    data.SetPolys(cells)
    if "colours" in made:
        colours = vtk.vtkUnsignedCharArray()
        colours.SetName("colours")
        colours.SetNumberOfComponents(3)
        for colour in made["colours"]:
            colours.InsertNextTuple3(*colour)
        data.GetPointData().SetScalars(colours)
    if "uv" in made:
        uv = vtk.vtkFloatArray()
        uv.SetName("uv")
        uv.SetNumberOfComponents(2)
        for pair in made["uv"]:
            uv.InsertNextTuple2(*pair)
        data.GetPointData().SetTCoords(uv)
    return data


def write(writer, data, path, binary):
    writer.SetFileName(path)
    writer.SetInputData(data)
    if binary is not None:
        writer.SetFileType(vtk.VTK_BINARY if binary else vtk.VTK_ASCII)
    writer.Write()


for made, stem in shapes():
    data = poly_data(made)
    for binary, word in ((False, "ascii"), (True, "binary")):
        ply = vtk.vtkPLYWriter()
        ply.SetArrayName("colours")
        write(ply, data, f"{stem}.{word}.ply", binary)
        write(vtk.vtkSTLWriter(), data, f"{stem}.{word}.stl", binary)
    big = vtk.vtkPLYWriter()
    big.SetDataByteOrderToBigEndian()
    write(big, data, f"{stem}.big.ply", True)
    write(vtk.vtkOBJWriter(), data, f"{stem}.obj", None)
