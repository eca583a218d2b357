"""A simplex as SVG, in floats, for the eye."""

import itertools

import numpy


def simplex_svg(vertices):
    """The edges of a simplex, seen along the directions in which it is thinnest: a triangle in its own plane, and with its
    circumcircle as far as that fits into a frame three times as large. None for fewer than two vertices."""
    points = numpy.array([[float(x) for x in vertex] for vertex in vertices])
    if len(points) < 2:
        return None
    centred = points - points.mean(axis=0)
    axes = numpy.linalg.svd(centred, full_matrices=False)[2]
    flat = numpy.zeros((len(points), 2))
    shown = centred @ axes[:2].T
    flat[:, : shown.shape[1]] = shown
    size = float(numpy.abs(flat).max()) or 1.0
    circle = circumcircle(flat) if len(points) == 3 else None
    reach = 1.1 * size
    if circle is not None and numpy.abs(circle[0]).max() + circle[1] < 3 * size:
        reach = max(reach, 1.05 * float(numpy.abs(circle[0]).max() + circle[1]))
    scale = 180 / reach

    def place(point):
        return f"{200 + scale * point[0]:.2f}", f"{200 - scale * point[1]:.2f}"

    parts = ['<svg xmlns="http://www.w3.org/2000/svg" width="400" height="400" viewBox="0 0 400 400">']
    if circle is not None and scale * circle[1] < 1e5:
        x, y = place(circle[0])
        parts.append(f'<circle cx="{x}" cy="{y}" r="{scale * circle[1]:.2f}" fill="none" stroke="#c8102e" stroke-width="1.5"/>')
    for a, b in itertools.combinations(flat, 2):
        (x1, y1), (x2, y2) = place(a), place(b)
        parts.append(f'<line x1="{x1}" y1="{y1}" x2="{x2}" y2="{y2}" stroke="#1c3144" stroke-width="2"/>')
    for at, point in enumerate(flat):
        x, y = place(point)
        parts.append(f'<circle cx="{x}" cy="{y}" r="4" fill="#1c3144"/><text x="{x}" y="{y}" dx="6" dy="-6" font-size="14">p{at}</text>')
    return "\n".join([*parts, "</svg>"])


def circumcircle(triangle):
    """Centre and radius; None where the triangle is degenerate to double precision."""
    a, b = triangle[1] - triangle[0], triangle[2] - triangle[0]
    twice_area = a[0] * b[1] - a[1] * b[0]
    if abs(twice_area) < 1e-12 * (a @ a + b @ b):
        return None
    centre = numpy.array([b[1] * (a @ a) - a[1] * (b @ b), a[0] * (b @ b) - b[0] * (a @ a)]) / (2 * twice_area)
    return triangle[0] + centre, float(numpy.hypot(*centre))
