"""Tables of what the bench measured."""
import sys

ROW = "{:5}{:4}{:26}{:10}{:9}{:>4}{:>9}{:>9}{:>7}{:>7}{:>6}{:>7}{:>7}{:>8}{:>7}"


def ratios(results):
    """FreeType's instructions by core, optimisation, font and size."""
    return {(r["cpu"], r["opt"], r["font"], r["px"]): r["instructions_mean"]
            for r in results if r["engine"] == "freetype"}


def print_table(results):
    """One row a result; the last column is FreeType's instructions over it."""
    print(ROW.format("cpu", "opt", "font", "engine", "coding", "px", "mean",
                     "worst", "stack", "heap", "ram", "lent", "code", "font",
                     "ratio"), file=sys.stderr)
    freetype = ratios(results)
    for r in results:
        other = freetype.get((r["cpu"], r["opt"], r["font"], r["px"]))
        ratio = f"{other / r['instructions_mean']:.2f}" if other else ""
        print(ROW.format(r["cpu"], r["opt"], r["font"], r["engine"],
                         r.get("coding", ""), r["px"], r["instructions_mean"],
                         r["instructions_max"], r["stack"], r["heap"],
                         r["static_ram"], r.get("workspace", ""), r["code"],
                         r["font_bytes"], ratio), file=sys.stderr, flush=True)


def print_others(figures):
    for figure in figures:
        print("  ".join(f"{name} {value}" for name, value in figure.items()),
              file=sys.stderr, flush=True)
