# Takes numbers in the units of a diagram; gives it as SVG on a white card, for light and dark pages.
import math

# Told apart by the colour-blind: after Okabe and Ito, "Color universal design", 2008.
BLUE, RED, GREEN, VIOLET, AMBER = "#0072b2", "#d55e00", "#009e73", "#a8488a", "#e69f00"
INK, GREY, GRID = "#24292f", "#6e7781", "#e4e8ec"
FONT = "font-family=\"'Segoe UI','Helvetica Neue',Arial,sans-serif\""


def number(value):
    """Short enough to look at: two decimals, and none that say nothing."""
    return f"{value:.2f}".rstrip("0").rstrip(".") if value else "0"


def escape(text):
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")


def text(x, y, words, color=INK, size=13, anchor="start", weight="normal", turned=False):
    turn = f' transform="rotate(-90 {number(x)} {number(y)})"' if turned else ""
    return (f'<text x="{number(x)}" y="{number(y)}" fill="{color}" font-size="{size}" '
            f'font-weight="{weight}" text-anchor="{anchor}"{turn}>{escape(words)}</text>')


def ticks_of(low, high, count=6):
    """Round numbers from low to high: steps of 1, 2 or 5 times a power of ten."""
    rough = (high - low) / count
    power = 10.0 ** math.floor(math.log10(rough))
    step = min((s * power for s in (1, 2, 5, 10)), key=lambda s: abs(math.log(s / rough)))
    first = math.ceil(low / step - 1e-9)
    return [i * step for i in range(first, math.floor(high / step + 1e-9) + 1)]


class Panel:
    """One pair of axes. Everything given to it is in the axes' units."""

    def __init__(self, box, x, y, x_label="", y_label="", title="", is_log=False,
                 x_ticks=None, y_ticks=None, tick_text=lambda v: f"{v:g}"):
        self.left, self.top, self.width, self.height = box
        self.is_log = is_log
        self.x_range, self.y_range = [tuple(map(self._scale, r)) for r in (x, y)]
        self.clip = f"c{self.left:.0f}x{self.top:.0f}"
        self.marks, self.over = [], []
        x_ticks = self._ticks(x) if x_ticks is None else x_ticks
        y_ticks = self._ticks(y) if y_ticks is None else y_ticks
        self._axes(x_ticks, y_ticks, x_label, y_label, title, tick_text)

    def _scale(self, value):
        return math.log10(value) if self.is_log else value

    def _ticks(self, span):
        if not self.is_log:
            return ticks_of(*span)
        return [10.0 ** e for e in range(math.ceil(math.log10(span[0])), math.floor(math.log10(span[1])) + 1)]

    def x(self, value):
        low, high = self.x_range
        return self.left + (self._scale(value) - low) / (high - low) * self.width

    def y(self, value):
        low, high = self.y_range
        return self.top + self.height - (self._scale(value) - low) / (high - low) * self.height

    def _axes(self, x_ticks, y_ticks, x_label, y_label, title, tick_text):
        bottom, right = self.top + self.height, self.left + self.width
        self.frame = []
        for tick in x_ticks:
            self.frame.append(f'<path d="M{number(self.x(tick))} {self.top}V{bottom}" stroke="{GRID}"/>')
            self.frame.append(text(self.x(tick), bottom + 18, tick_text(tick), GREY, 12, "middle"))
        for tick in y_ticks:
            self.frame.append(f'<path d="M{self.left} {number(self.y(tick))}H{right}" stroke="{GRID}"/>')
            self.frame.append(text(self.left - 8, self.y(tick) + 4, tick_text(tick), GREY, 12, "end"))
        self.frame.append(f'<path d="M{self.left} {self.top}V{bottom}H{right}" fill="none" stroke="{GREY}"/>')
        self.frame.append(text(self.left + self.width / 2, bottom + 38, x_label, INK, 13, "middle"))
        middle = self.top + self.height / 2
        self.frame.append(text(self.left - 44, middle, y_label, INK, 13, "middle", turned=True))
        self.frame.append(text(self.left, self.top - 12, title, INK, 14, weight="600"))

    def line(self, points, color, dash="", width=2.2):
        path = "L".join(f"{number(self.x(x))} {number(self.y(y))}" for x, y in points)
        dashes = f' stroke-dasharray="{dash}"' if dash else ""
        self.marks.append(f'<path d="M{path}" fill="none" stroke="{color}" stroke-width="{width}" '
                          f'stroke-linejoin="round" stroke-linecap="round"{dashes}/>')

    def dots(self, points, color, radius=3.5, fill=None):
        for x, y in points:
            self.over.append(f'<circle cx="{number(self.x(x))}" cy="{number(self.y(y))}" r="{radius}" '
                             f'fill="{fill or color}" stroke="{color}" stroke-width="1.5"/>')

    def note(self, x, y, words, color=INK, anchor="start", dx=0, dy=0, size=13):
        """Words at a place, moved by dx and dy pixels; on a white ground, so that lines do not cross them."""
        self.over.append(text(self.x(x) + dx, self.y(y) + dy, words, color, size, anchor).replace(
            "<text ", '<text paint-order="stroke" stroke="#fff" stroke-width="4" stroke-linejoin="round" ', 1))

    def rule(self, x=None, y=None, color=GREY, dash="3 4"):
        where = f"M{number(self.x(x))} {self.top}v{self.height}" if y is None else \
            f"M{self.left} {number(self.y(y))}h{self.width}"
        self.marks.append(f'<path d="{where}" stroke="{color}" stroke-dasharray="{dash}"/>')

    def svg(self):
        clip = (f'<clipPath id="{self.clip}"><rect x="{self.left}" y="{self.top - 3}" '
                f'width="{self.width + 3}" height="{self.height + 6}"/></clipPath>')
        return "\n".join(self.frame + [clip, f'<g clip-path="url(#{self.clip})">', *self.marks, "</g>", *self.over])


def card(width, height, parts, description):
    """The whole picture; `description` is for those who cannot see it."""
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" '
            f'height="{height}" role="img" {FONT}>\n<title>{escape(description)}</title>\n'
            f'<rect x=".5" y=".5" width="{width - 1}" height="{height - 1}" rx="8" fill="#fff" stroke="#d0d7de"/>\n'
            + "\n".join(parts) + "\n</svg>\n")
