// Draws plots: a quantity against time, or against another one, with the moment that is shown.

const plotHeight = 150;

/** Returns a range with round ends around the numbers. */
function rangeOf(values) {
    let low = Infinity;
    let high = -Infinity;
    for (const value of values) {
        if (Number.isFinite(value)) {
            low = Math.min(low, value);
            high = Math.max(high, value);
        }
    }
    if (low > high)
        return { low: 0, high: 1, step: 0.5 };
    const size = Math.max(Math.abs(low), Math.abs(high), 1e-9);
    if (high - low < 1e-6 * size) {
        low -= 0.1 * size;
        high += 0.1 * size;
    }
    const rough = (high - low) / 3;
    const power = 10 ** Math.floor(Math.log10(rough));
    const step = [1, 2, 5, 10].map((factor) => factor * power).find((one) => one >= rough);
    return { low: Math.floor(low / step) * step, high: Math.ceil(high / step) * step, step };
}

function shortNumber(value, step = 0) {
    if (!Number.isFinite(value))
        return "–";
    const digits = step > 0 ? Math.max(0, -Math.floor(Math.log10(step) + 1e-9)) : 2;
    const size = Math.abs(value);
    const isPlain = size < 1e6 && (size === 0 || size >= 1e-3 || digits < 4);
    return (isPlain ? value.toFixed(Math.min(digits, 8)) : value.toExponential(1))
        .replace("e+", "e").replaceAll("-", "−").replace(".", decimalSign);
}

class Plot {
    constructor(plot, run, words) {
        this.run = run;
        const read = (axis) => ({ ...axis, values: run.column(axis.values, run.count) });
        this.up = read(plot.up);
        const frames = Float64Array.from({ length: run.count }, (_, i) => run.first + i * run.every);
        this.isTime = !plot.across;
        this.across = plot.across ? read(plot.across) : { title: words.time, unit: "", values: frames, down: false };
        this.upRange = rangeOf(this.up.values);
        this.acrossRange = this.isTime
            ? { ...rangeOf(frames), low: frames[0], high: Math.max(frames[0] + 1, frames.at(-1)) }
            : rangeOf(this.across.values);
        this.words = words;
        this.canvas = make("canvas", { role: "img" });
        this.value = make("span", { class: "number" });
        const title = this.isTime ? this.up.title : `${this.up.title} – ${this.across.title}`;
        this.element = make("figure", { class: "plot" },
                            make("figcaption", {}, make("span", {}, title), this.value), this.canvas);
        this.title = title;
        this.width = 0;
        this.drawn = 0; // frames in the path of those up to the one that is shown
    }

    /** Gives the canvas the size that it has on the screen. */
    resize(ratio) {
        this.width = this.canvas.clientWidth;
        this.ratio = ratio;
        this.canvas.width = Math.round(this.width * ratio);
        this.canvas.height = Math.round(plotHeight * ratio);
        this.whole = this.width > 0 ? this.addPath(new Path2D(), 0, this.run.count) : null;
        this.drawn = 0;
    }

    x(i) {
        const { low, high } = this.acrossRange;
        return 52 + (this.across.values[i] - low) / (high - low) * (this.width - 64);
    }

    y(value) {
        const { low, high } = this.upRange;
        const share = (value - low) / (high - low);
        return 8 + (this.up.down ? share : 1 - share) * (plotHeight - 30);
    }

    /** Returns the frame of the page at a place of the canvas; -1 if the plot has no time. */
    indexAt(x) {
        if (!this.isTime)
            return -1;
        const share = Math.min(1, Math.max(0, (x - 52) / (this.width - 64)));
        return Math.round(share * (this.run.count - 1));
    }

    /** Shows frame `index` of the page. */
    show(index, colors) {
        const value = this.up.values[index];
        const unit = this.up.unit ? "\u202f" + this.up.unit : "";
        const text = Number.isFinite(value) ? shortNumber(value) + unit : this.words.noValue;
        if (text !== this.text)
            this.value.textContent = this.text = text;
        if (!this.whole)
            return;
        this.colors = colors;
        const pen = this.canvas.getContext("2d");
        pen.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
        pen.clearRect(0, 0, this.width, plotHeight);
        this.drawAxes(pen);
        pen.lineWidth = 1.6;
        pen.lineJoin = "round";
        pen.strokeStyle = colors.line2;
        pen.stroke(this.whole);
        pen.strokeStyle = colors.link;
        pen.stroke(this.pathTo(index));
        this.drawCursor(pen, index);
    }

    /** Tells screen readers the value. */
    describe() {
        this.canvas.setAttribute("aria-label", `${this.title}: ${this.text}`);
    }

    /** Returns the curve up to a frame. It goes on from the last one while the run plays. */
    pathTo(index) {
        if (this.drawn === 0 || index < this.drawn - 1) {
            this.path = new Path2D();
            this.drawn = 0;
        }
        this.addPath(this.path, Math.max(0, this.drawn - 1), index + 1);
        this.drawn = index + 1;
        return this.path;
    }

    addPath(path, begin, end) {
        const every = Math.max(1, Math.floor(this.run.count / 4000));
        let isOn = false;
        for (let i = Math.floor(begin / every) * every; i < end; i += every) {
            const value = this.up.values[i];
            if (!Number.isFinite(value) || !Number.isFinite(this.across.values[i])) {
                isOn = false;
                continue;
            }
            isOn ? path.lineTo(this.x(i), this.y(value)) : path.moveTo(this.x(i), this.y(value));
            isOn = true;
        }
        return path;
    }

    drawAxes(pen) {
        const { low, high, step } = this.upRange;
        pen.font = "11px Inter, system-ui, sans-serif";
        pen.fillStyle = this.colors.ink3;
        pen.strokeStyle = this.colors.line;
        pen.lineWidth = 1;
        pen.textAlign = "right";
        pen.textBaseline = "middle";
        for (let k = 0; low + k * step <= high + step / 2; ++k) {
            const y = Math.round(this.y(low + k * step)) + 0.5;
            pen.beginPath();
            pen.moveTo(52, y);
            pen.lineTo(this.width - 12, y);
            pen.stroke();
            pen.fillText(shortNumber(low + k * step, step), 46, y);
        }
        const across = this.acrossRange;
        pen.textBaseline = "top";
        pen.textAlign = "left";
        pen.fillText(shortNumber(across.low, across.step), 52, plotHeight - 16);
        pen.textAlign = "right";
        pen.fillText(shortNumber(across.high, across.step), this.width - 12, plotHeight - 16);
        pen.textAlign = "center";
        const unit = this.across.unit ? ", " + this.across.unit : "";
        pen.fillText(this.across.title + unit, this.width / 2 + 20, plotHeight - 16);
    }

    drawCursor(pen, index) {
        const value = this.up.values[index];
        const x = this.x(index);
        if (!Number.isFinite(x))
            return;
        if (this.isTime) {
            pen.strokeStyle = this.colors.now;
            pen.lineWidth = 1.5;
            pen.beginPath();
            pen.moveTo(x, 6);
            pen.lineTo(x, plotHeight - 20);
            pen.stroke();
        }
        if (!Number.isFinite(value))
            return;
        pen.fillStyle = this.colors.now;
        pen.strokeStyle = this.colors.scene;
        pen.lineWidth = 1.5;
        pen.beginPath();
        pen.arc(x, this.y(value), 4.5, 0, 2 * Math.PI);
        pen.fill();
        pen.stroke();
    }
}
