#!/usr/bin/env python3
"""Draws docs/pictures/tuning.svg of the curves of tuning_report: gain and phase of the drive, and the two steps.

usage: tuning_report curves.csv && python3 examples/tuning/picture.py curves.csv docs/pictures/tuning.svg
"""
import math
import sys

WIDTH, HEIGHT, LEFT, GAP = 700, 190, 62, 34


def line(points, color):
    return f'<polyline fill="none" stroke="{color}" stroke-width="2" points="{" ".join(f"{x:.1f},{y:.1f}" for x, y in points)}"/>'


def panel(top, title, curves, xs, ys, log, x_marks, y_marks):
    """Curves of [(x, y)] with their colors and names, in their ranges."""
    scale = math.log10 if log else float
    x_of = lambda x: LEFT + (scale(x) - scale(xs[0])) / (scale(xs[1]) - scale(xs[0])) * (WIDTH - LEFT - 12)
    y_of = lambda y: top + HEIGHT - GAP - (y - ys[0]) / (ys[1] - ys[0]) * (HEIGHT - GAP - 24)
    parts = [f'<text x="{LEFT}" y="{top + 12}" font-weight="bold">{title}</text>']
    for x in x_marks:
        parts.append(f'<path d="M{x_of(x):.1f} {y_of(ys[0]):.1f}V{y_of(ys[1]):.1f}" stroke="#ddd"/>'
                     f'<text x="{x_of(x):.1f}" y="{y_of(ys[0]) + 16:.1f}" text-anchor="middle">{x:g}</text>')
    for y in y_marks:
        parts.append(f'<path d="M{LEFT} {y_of(y):.1f}H{WIDTH - 12}" stroke="#ddd"/>'
                     f'<text x="{LEFT - 6}" y="{y_of(y) + 4:.1f}" text-anchor="end">{y:g}</text>')
    for i, (points, color, name) in enumerate(curves):
        inside = [(x, y) for x, y in points if xs[0] <= x <= xs[1]]
        parts.append(line([(x_of(x), y_of(min(max(y, ys[0]), ys[1]))) for x, y in inside], color))
        parts.append(f'<text x="{WIDTH - 16 - 150 * i}" y="{top + 12}" text-anchor="end" fill="{color}">{name}</text>')
    return "".join(parts)


def main(source, target):
    rows = [row.strip().split(",") for row in open(source)]
    bode = [[float(x) for x in row[1:]] for row in rows if row[0] == "bode"]
    step = [[float(x) for x in row[1:]] for row in rows if row[0] == "step"]
    decibel = lambda gain: 20 * math.log10(gain)
    blue, orange = "#0072b2", "#b25000"
    marks = [1, 2, 5, 10, 20]
    text = "".join([
        panel(4, "gain, dB, over Hz", [([(f, decibel(g)) for f, g, *_ in bode], blue, "drive, rad/(N m)"),
                                       ([(r[0], decibel(r[4])) for r in bode], orange, "closed loop")],
              (0.7, 40), (-60, 20), True, marks, [-60, -40, -20, 0, 20]),
        panel(4 + HEIGHT, "phase, degrees, over Hz", [([(r[0], r[2]) for r in bode], blue, "drive"),
                                                      ([(r[0], r[5]) for r in bode], orange, "closed loop")],
              (0.7, 40), (-225, 0), True, marks, [-180, -135, -90, -45, 0]),
        panel(4 + 2 * HEIGHT, "answer to a step of 0.1 rad, rad, over s", [([(t, b - step[0][1]) for t, b, a in step], orange, "before"),
                                                                           ([(t, a - step[0][2]) for t, b, a in step], blue, "after")],
              (0, 1.2), (0, 0.15), False, [0, 0.2, 0.4, 0.6, 0.8, 1, 1.2], [0, 0.05, 0.1, 0.15])])
    with open(target, "w") as file:
        file.write(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {3 * HEIGHT + 8}" width="{WIDTH}" '
                   f'font-family="sans-serif" font-size="12"><rect width="100%" height="100%" fill="white"/>{text}</svg>\n')


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2])
