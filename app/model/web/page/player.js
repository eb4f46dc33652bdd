// The element <springstep-run>, which plays the run whose data is in the element that its attribute `data` names.

const icons = {
    play: "<path class='solid' d='M5 3l10 6-10 6z'/>",
    pause: "<path class='solid' d='M4 3h3v12H4zM11 3h3v12h-3z'/>",
    start: "<path d='M4 4v10'/><path class='solid' d='M14 4L7 9l7 5z'/>",
    back: "<path class='solid' d='M12 4L5 9l7 5z'/><path d='M14.5 4v10'/>",
    forward: "<path class='solid' d='M6 4l7 5-7 5z'/><path d='M3.5 4v10'/>",
    zoomIn: "<circle cx='8' cy='8' r='5'/><path d='M12 12l4 4M8 5.8v4.4M5.8 8h4.4'/>",
    zoomOut: "<circle cx='8' cy='8' r='5'/><path d='M12 12l4 4M5.8 8h4.4'/>",
    fit: "<path d='M2 6V2h4M12 2h4v4M16 12v4h-4M6 16H2v-4'/>",
    show: "<path d='M1.5 9C3.5 5.5 6 4 9 4s5.5 1.5 7.5 5c-2 3.5-4.5 5-7.5 5s-5.5-1.5-7.5-5z'/><circle class='solid' cx='9' cy='9' r='2.4'/>",
    light: "<circle cx='9' cy='9' r='3.4'/><path d='M9 1v2M9 15v2M1 9h2M15 9h2M3.3 3.3l1.4 1.4M13.3 13.3l1.4 1.4M14.7 3.3l-1.4 1.4M4.7 13.3l-1.4 1.4'/>",
    dark: "<path d='M15 11A6.5 6.5 0 0 1 7 3a6.5 6.5 0 1 0 8 8z'/>",
};
const switches = { trails: "t", velocities: "v", onion: "o", ghost: "g", guides: "l", unitCircle: "u" }; // with their keys
const speeds = [0.1, 0.25, 0.5, 1, 2, 4];
const zoomStep = 1.25;
const panStep = 60; // px

/** Makes an element. Texts among `children` stay texts. */
function make(name, attributes = {}, ...children) {
    const element = document.createElement(name);
    for (const [key, value] of Object.entries(attributes))
        element.setAttribute(key, value);
    element.append(...children);
    return element;
}

function iconOf(name) {
    const icon = make("span", { "aria-hidden": "true" });
    icon.innerHTML = `<svg viewBox="0 0 18 18">${icons[name]}</svg>`; // only texts of this file
    return icon;
}

/** Puts texts in place of %1, %2... */
function filled(text, ...values) {
    return text.replace(/%(\d)/g, (whole, digit) => values[digit - 1] ?? whole);
}

class SpringstepRun extends HTMLElement {
    #run = null;
    #index = 0;
    #isPlaying = false;
    #speed = 1;
    #owed = 0;
    #last = 0;
    #isDue = false;
    #pointers = new Map(); // that hold the picture, by id
    #isHome = true; // the reader has not moved the view
    #follows = true; // the view follows a body that walks
    #chosen = ""; // the colours that the reader has chosen: "light", "dark"

    async connectedCallback() {
        if (this.#run)
            return;
        try {
            this.#run = await unpack(document.getElementById(this.getAttribute("data")).textContent);
        } catch {
            this.#complain();
            return;
        }
        readFigures(this.#run);
        this.motion = this.#run.figures.map((figure) => motionBox(figure).moved(figure.shiftX, figure.shiftY))
            .reduce((a, b) => a.united(b));
        this.#build();
        this.#listen();
        this.#resize();
        this.setAttribute("ready", "");
        this.dispatchEvent(new Event("ready"));
    }

    /** Says why there is no run. */
    #complain() {
        const isOld = typeof DecompressionStream === "undefined";
        this.querySelector(".message").textContent = this.getAttribute(isOld ? "too-old" : "damaged");
    }

    // What other scripts of the page can use.

    /** The number of frames on the page. */
    get count() { return this.#run.count; }
    /** The index of the frame that is shown, from 0. */
    get index() { return this.#index; }
    set index(index) { this.#show(index); }
    /** The number of the frame that is shown, as in the window. */
    get frame() { return this.#run.first + this.#index * this.#run.every; }
    set frame(frame) { this.#show(Math.round((frame - this.#run.first) / this.#run.every)); }
    get isPlaying() { return this.#isPlaying; }
    get zoom() { return this.painter.camera.zoom; }
    /** The names of the bodies at the frame that is shown. */
    get bodies() { return partAt(this.#run.figures[0], this.#index).part.names; }
    /** Returns the position of a body at a frame, in px of the scene. */
    positionOf(body, frame = this.frame) {
        const { part, i } = partAt(this.#run.figures[0], Math.round((frame - this.#run.first) / this.#run.every));
        const point = part.names.indexOf(body);
        return point < 0 ? null : { x: part.x[point][i], y: part.y[point][i] };
    }
    /** Returns the velocity of a body at the frame that is shown, in px/frame; null if the page has none. */
    velocityOf(body) {
        const { part, i } = partAt(this.#run.figures[0], this.#index);
        const point = part.names.indexOf(body);
        return point < 0 || part.vx.length === 0 ? null : { x: part.vx[point][i], y: part.vy[point][i] };
    }
    /** Returns where a place of the scene is on the screen, in px from the top left corner of the picture. */
    placeOnScreen(x, y) { return this.painter.camera.at(x, y); }
    /** Returns the text beside a line of the listing (from 1). */
    valueAt(line) { return this.listing ? this.listing.textAt(line, this.#index) : ""; }
    play() {
        if (this.#isPlaying)
            return;
        if (this.#index === this.count - 1)
            this.#show(0);
        this.#isPlaying = true;
        this.#owed = 0;
        this.#last = performance.now();
        this.#showPlaying();
        requestAnimationFrame((now) => this.#tick(now));
    }
    pause() {
        this.#isPlaying = false;
        this.#showPlaying();
        this.#drawSoon(); // which also tells screen readers the moment
    }

    // The parts of the page.

    #button(name, act, attributes = {}) {
        const text = this.#run.words[name];
        const button = make("button", { type: "button", "aria-label": text, title: text, name, ...attributes }, iconOf(name));
        button.addEventListener("click", act);
        return button;
    }

    #build() {
        const run = this.#run;
        const words = run.words;
        const details = [run.lesson, run.method, run.run].filter(Boolean).join(" · ");
        this.colours = this.#button("dark", () => this.#changeColours());
        const top = make("header", { class: "top" },
                         make("hgroup", {}, make("h1", {}, run.title), make("p", {}, details)), this.colours);
        this.replaceChildren(top, this.#buildStage(words), this.#buildBeside(words));
        this.painter = new Painter(this.canvas, run);
        this.#showColours();
    }

    #buildStage(words) {
        this.canvas = make("canvas", { tabindex: "0", role: "img", "aria-label": words.scene });
        this.note = make("p", { class: "note", role: "status" });
        this.legend = new Legend(words);
        if (this.#run.figures[0].parts.some((part) => part.view.angle))
            this.circle = new UnitCircle(words);
        const tools = make("div", { class: "tools", role: "group", "aria-label": words.scene }, this.#buildShow(words),
                           this.#button("zoomOut", () => this.#zoom(1 / zoomStep)),
                           this.#button("zoomIn", () => this.#zoom(zoomStep)),
                           this.#button("fit", () => this.#home()));
        this.playButton = this.#button("play", () => this.#playOrPause(), { class: "play" });
        this.slider = make("input", { type: "range", min: "0", max: String(this.count - 1), value: "0", step: "1",
                                      "aria-label": words.frame, title: words.frame });
        this.clockFrame = make("strong");
        this.clockTime = make("span");
        this.clock = make("span", { class: "clock" }, this.clockFrame, " ", this.clockTime);
        this.speedBox = make("select", { "aria-label": words.speed, title: words.speed }, ...speeds.map((speed) => {
            const option = make("option", { value: String(speed) }, `${plainNumber(speed)}\u202f×`);
            option.selected = speed === 1;
            return option;
        }));
        const time = make("div", { class: "time", role: "group", "aria-label": words.frame },
                          this.#button("start", () => this.#step(-this.count)),
                          this.#button("back", () => this.#step(-1)), this.playButton,
                          this.#button("forward", () => this.#step(1)), this.slider, this.clock, this.speedBox);
        this.view = make("div", { class: "view" }, this.canvas, this.note, this.legend.element, tools);
        return make("main", { class: "stage" }, this.view, time);
    }

    /** Makes the menu of what the scene can show. */
    #buildShow(words) {
        const run = this.#run;
        const parts = run.figures.flatMap((figure) => figure.parts);
        const has = {
            trails: parts.some((part) => !part.view.tree && part.names.length <= mostTrailed),
            velocities: run.velocityUnits.some((unit) => unit > 0),
            onion: true,
            ghost: run.ghost !== undefined,
            guides: parts.some((part) => part.drawings.some((one) => one.shapes.length > 0)),
            unitCircle: this.circle !== undefined,
        };
        this.boxes = {};
        const choices = Object.keys(switches).filter((name) => has[name]).map((name) => {
            const box = make("input", { type: "checkbox", name, "aria-label": words[name], "aria-keyshortcuts": switches[name] });
            box.checked = run.shows[name];
            box.addEventListener("change", () => this.#switch(name));
            this.boxes[name] = box;
            return make("label", {}, box, make("span", {}, words[name]), make("kbd", { "aria-hidden": "true" }, switches[name].toUpperCase()));
        });
        this.menu = make("details", { class: "show" }, make("summary", { title: words.showHelp }, iconOf("show"), words.show),
                         make("div", { class: "menu", role: "group", "aria-label": words.show }, ...choices));
        return this.menu;
    }

    #buildBeside(words) {
        const run = this.#run;
        const beside = make("aside", { class: run.listing ? "beside crowded" : "beside" });
        if (run.end)
            beside.append(make("p", {}, run.end));
        const section = (kind, title, ...children) =>
            make("section", { class: kind, "aria-label": title }, make("h2", {}, title), ...children);
        const text = make("details", { class: "prose" }, make("summary", {}, words.text), ...proseOf(run.text));
        text.open = true;
        if (run.text)
            beside.append(text);
        if (run.listing) {
            this.listing = new Listing(run.listing);
            this.listing.element.setAttribute("aria-label", words.listing);
            beside.append(section("code", words.listing, make("p", { class: "hint" }, words.listingHelp), this.listing.element));
        }
        this.plots = run.plots.map((plot) => new Plot(plot, run, words));
        if (this.plots.length > 0)
            beside.append(section("plots", words.plots, ...this.plots.map((plot) => plot.element)));
        const keys = [["keySpace", "playPause"], ["keyArrows", "oneFrame"], ["keyEnds", "firstLast"],
                      ["keyMove", "moveView"], ["keyWheel", "zoomView"]];
        const list = keys.flatMap(([key, does]) => [make("dt", {}, words[key]), make("dd", {}, words[does])]);
        const letters = Object.keys(this.boxes).map((name) => [switches[name].toUpperCase(), words[name]]);
        for (const [key, does] of [["+ −", words.zoomView], ["0", words.fit], ["C", words.otherColours], ...letters])
            list.push(make("dt", {}, key), make("dd", {}, does));
        beside.append(make("details", { class: "keys" }, make("summary", {}, words.keys), make("dl", {}, ...list)),
                      make("p", { class: "made" }, words.made));
        return beside;
    }

    #listen() {
        document.addEventListener("keydown", (event) => this.#takeKey(event));
        document.addEventListener("pointerdown", (event) => {
            if (!this.menu.contains(event.target))
                this.menu.open = false;
        });
        this.slider.addEventListener("input", () => {
            this.pause();
            this.#show(Number(this.slider.value));
        });
        this.speedBox.addEventListener("change", () => { this.#speed = Number(this.speedBox.value); });
        this.canvas.addEventListener("pointerdown", (event) => this.#takeHold(event));
        this.canvas.addEventListener("pointermove", (event) => this.#dragView(event));
        for (const name of ["pointerup", "pointercancel"])
            this.canvas.addEventListener(name, (event) => this.#letGo(event));
        this.canvas.addEventListener("wheel", (event) => {
            event.preventDefault();
            const { left, top } = this.canvas.getBoundingClientRect();
            this.#zoom(zoomStep ** (-event.deltaY / 120), event.clientX - left, event.clientY - top);
        }, { passive: false });
        this.canvas.addEventListener("dblclick", () => this.#home());
        for (const plot of this.plots)
            plot.canvas.addEventListener("pointerdown", (event) => this.#scrubPlot(plot, event));
        const sizes = new ResizeObserver(() => this.#resize());
        for (const canvas of [this.canvas, ...this.plots.map((plot) => plot.canvas)])
            sizes.observe(canvas);
        addEventListener("beforeprint", () => this.#useColours("light"));
        addEventListener("afterprint", () => this.#useColours(this.#chosen));
        matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.#showColours());
    }

    // Time.

    #tick(now) {
        if (!this.#isPlaying)
            return;
        this.#owed += Math.min(0.25, (now - this.#last) / 1000) * this.#run.rate * this.#speed / this.#run.every;
        this.#last = now;
        const due = Math.floor(this.#owed);
        if (due > 0) {
            this.#owed -= due;
            this.#show(this.#index + due);
        }
        if (this.#index === this.count - 1)
            this.pause();
        else
            requestAnimationFrame((next) => this.#tick(next));
    }

    #playOrPause() {
        this.#isPlaying ? this.pause() : this.play();
    }

    #step(frames) {
        this.pause();
        this.#show(this.#index + frames);
    }

    #show(index) {
        this.#index = Math.min(this.count - 1, Math.max(0, index));
        const { part, i } = partAt(this.#run.figures[0], this.#index);
        if (this.#follows)
            followX(this.painter.camera, part, i, 0.4, 0.5);
        this.#drawSoon();
        this.dispatchEvent(new Event("framechange"));
    }

    #showPlaying() {
        const name = this.#isPlaying ? "pause" : "play";
        const text = this.#run.words[name];
        this.playButton.replaceChildren(iconOf(name));
        this.playButton.setAttribute("aria-label", text);
        this.playButton.title = text;
    }

    /** Draws before the screen is painted next, once for all changes until then. */
    #drawSoon() {
        if (this.#isDue)
            return;
        this.#isDue = true;
        requestAnimationFrame(() => this.#draw());
    }

    #draw() {
        this.#isDue = false;
        const { words, first, every, notes } = this.#run;
        this.#placeCircle();
        this.painter.draw(this.#index);
        this.slider.value = String(this.#index);
        this.slider.style.setProperty("--share", `${100 * this.#index / Math.max(1, this.count - 1)}%`);
        this.clockFrame.textContent = filled(words.frameOf, this.frame, first + (this.count - 1) * every);
        this.clockTime.textContent = filled(words.seconds, fixedNumber(this.frame / 30, 2));
        const note = notes.findLast((one) => one.at <= this.#index)?.text ?? "";
        if (this.noted !== note)
            this.note.textContent = this.noted = note;
        this.#showLegend();
        this.listing?.show(this.#index);
        for (const plot of this.plots)
            plot.show(this.#index, this.plotColors);
        if (!this.#isPlaying)
            this.#describe();
    }

    #showLegend() {
        const { painter } = this;
        const { view } = partAt(this.#run.figures[0], this.#index).part;
        const floor = view.room?.floor ?? view.ground ?? Infinity;
        this.legend.element.classList.toggle("outdoors", view.dusk);
        this.legend.element.classList.toggle("low", painter.camera.at(0, floor).y < painter.camera.height - 30);
        const { words, velocityUnits, pullUnits, every, ghost } = this.#run;
        const unit = (is, units, text) => (is && units[this.#index] > 0 ? filled(text, plainNumber(units[this.#index])) : "");
        this.legend.show({
            ghost: painter.ghost ? ghost.name : "",
            onion: painter.shows.onion ? filled(words.onionScale, onionStep * every) : "",
            velocities: unit(painter.shows.velocities, velocityUnits, words.velocityScale),
            pulls: unit(painter.shows.guides, pullUnits, words.pullScale),
        });
    }

    /** Shows the unit circle in a corner of the scene, or below it where it would cover too much. */
    #placeCircle() {
        const { circle, painter } = this;
        painter.card = null;
        if (!circle)
            return;
        const { part, i } = partAt(this.#run.figures[0], this.#index);
        const arrow = painter.shows.unitCircle ? angleArrow(part, i) : null;
        circle.element.hidden = !arrow;
        if (!arrow)
            return;
        if (!circle.width)
            circle.measure();
        circle.show(arrow);
        if (this.isNarrow)
            return;
        const scene = painter.sceneOf(this.#run.figures[0], this.#index);
        const [from, to] = [arrow.from, arrow.to].map((place) => painter.camera.at(place.x, place.y));
        const [left, top] = circle.cornerIn(painter.camera, [
            ...boxesOfBodies(scene), Box.around(from.x, from.y, 4).united(Box.around(to.x, to.y, 4))]);
        circle.element.style.transform = `translate(${left}px, ${top}px)`;
        painter.card = new Box(left, top, left + circle.width, top + circle.height);
    }

    /** Tells screen readers the moment and where the bodies are, while time stands still. */
    #describe() {
        const words = this.#run.words;
        this.slider.setAttribute("aria-valuetext", `${this.clockFrame.textContent}, ${this.clockTime.textContent}`);
        this.plots.forEach((plot) => plot.describe());
        const { part, i } = partAt(this.#run.figures[0], this.#index);
        const bodies = part.names.map((name, point) => ({ name, point }))
            .filter(({ point }) => part.view.bodies[point].shape !== "none").slice(0, 8)
            .map(({ name, point }) => filled(words.bodyAt, name, Math.round(part.x[point][i]), Math.round(part.y[point][i])));
        this.canvas.setAttribute("aria-label", [words.scene, ...bodies].join(". "));
    }

    // The view.

    #resize() {
        const isOther = this.painter.resize();
        if (isOther && this.#isHome)
            this.#home();
        if (isOther)
            this.#putCircle();
        for (const plot of this.plots)
            plot.resize(this.painter.ratio);
        this.#draw(); // at once: a canvas of another size is empty
    }

    /** Puts the card of the unit circle on the scene, or below it on a small screen. */
    #putCircle() {
        if (!this.circle)
            return;
        this.isNarrow = matchMedia("(max-width: 820px)").matches;
        this.circle.element.style.transform = "";
        this.circle.element.classList.toggle("below", this.isNarrow);
        this.isNarrow ? this.view.after(this.circle.element) : this.view.append(this.circle.element);
        this.circle.width = 0; // to be measured
    }

    #home() {
        this.#isHome = true;
        this.#follows = true;
        const { part, i } = partAt(this.#run.figures[0], this.#index);
        frameRun(this.painter.camera, this.#run.figures, part, i, this.motion);
        this.#drawSoon();
    }

    #zoom(factor, x = this.painter.camera.width / 2, y = this.painter.camera.height / 2) {
        this.#isHome = false;
        this.painter.camera.zoomAt(factor, x, y);
        this.#drawSoon();
    }

    #pan(x, y) {
        this.#isHome = false;
        this.#follows = false;
        this.painter.camera.pan(x, y);
        this.#drawSoon();
    }

    #takeHold(event) {
        if (event.button !== 0)
            return;
        this.#pointers.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
        this.canvas.setPointerCapture(event.pointerId);
        this.canvas.classList.add("dragged");
    }

    /** One pointer moves the picture, two fingers also zoom it. */
    #dragView(event) {
        if (!this.#pointers.has(event.pointerId))
            return;
        const measure = () => {
            const all = [...this.#pointers.values()];
            const [first, last] = [all[0], all.at(-1)];
            return { x: (first.x + last.x) / 2, y: (first.y + last.y) / 2,
                     width: Math.hypot(last.x - first.x, last.y - first.y) };
        };
        const before = measure();
        this.#pointers.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
        const now = measure();
        this.#pan(now.x - before.x, now.y - before.y);
        if (before.width > 0 && now.width > 0)
            this.#zoom(now.width / before.width, now.x, now.y);
    }

    #letGo(event) {
        this.#pointers.delete(event.pointerId);
        this.canvas.classList.toggle("dragged", this.#pointers.size > 0);
    }

    #scrubPlot(plot, event) {
        const go = (to) => {
            const index = plot.indexAt(to.clientX - plot.canvas.getBoundingClientRect().left);
            if (index < 0)
                return;
            this.pause();
            this.#show(index);
        };
        go(event);
        plot.canvas.setPointerCapture(event.pointerId);
        plot.canvas.addEventListener("pointermove", go);
        plot.canvas.addEventListener("pointerup", () => plot.canvas.removeEventListener("pointermove", go), { once: true });
    }

    /** Shows or hides something in the scene. */
    #switch(name) {
        const { shows } = this.painter;
        shows[name] = !shows[name];
        this.boxes[name].checked = shows[name];
        this.#drawSoon();
    }

    #changeColours() {
        this.#chosen = this.painter.isDark ? "light" : "dark";
        this.#useColours(this.#chosen);
    }

    /** Draws in the light or the dark colours, or in those of the reader's system. */
    #useColours(colors) {
        if (colors)
            document.documentElement.dataset.colors = colors;
        else
            delete document.documentElement.dataset.colors;
        this.#showColours();
        this.#draw();
    }

    #showColours() {
        this.painter.takeColors();
        const style = getComputedStyle(document.documentElement);
        this.plotColors = Object.fromEntries(["scene", "ink3", "line", "line2", "link", "now"]
            .map((name) => [name, style.getPropertyValue("--" + name).trim()]));
        const name = this.painter.isDark ? "light" : "dark"; // what the button changes to
        this.colours.replaceChildren(iconOf(name));
        this.colours.setAttribute("aria-label", this.#run.words[name]);
        this.colours.title = this.#run.words[name];
        this.#drawSoon();
    }

    // Keys.

    #takeKey(event) {
        const target = event.target;
        if (event.altKey || event.metaKey || target === this.speedBox)
            return;
        const far = event.ctrlKey ? 10 : 1;
        const moves = { ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
        const isPressable = target.matches?.("button, summary, input[type=checkbox]");
        const acts = {
            " ": () => this.#playOrPause(),
            ArrowLeft: () => this.#step(-far),
            ArrowRight: () => this.#step(far),
            Home: () => this.#step(-this.count),
            End: () => this.#step(this.count),
        };
        const letters = {
            "+": () => this.#zoom(zoomStep),
            "=": () => this.#zoom(zoomStep),
            "-": () => this.#zoom(1 / zoomStep),
            0: () => this.#home(),
            c: () => this.#changeColours(),
        };
        for (const name of Object.keys(this.boxes))
            letters[switches[name]] = () => this.#switch(name);
        if (event.key === "Escape" && this.menu.open) {
            this.menu.open = false;
            this.menu.firstChild.focus();
            return;
        }
        let act = acts[event.key];
        if (event.shiftKey && moves[event.key])
            act = () => this.#pan(...moves[event.key].map((one) => one * panStep));
        else if (!event.ctrlKey && !act)
            act = letters[event.key.toLowerCase()];
        if (!act || (event.key === " " && isPressable))
            return;
        event.preventDefault();
        act();
    }
}

customElements.define("springstep-run", SpringstepRun);
