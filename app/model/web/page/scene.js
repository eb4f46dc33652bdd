// Draws one picture of the run.

const colorNames = ["scene", "win", "line2", "ink", "ink2", "ink3", "body", "bodyInk", "ghost", "dots", "spring", "contact",
                    "wind", "stick", "rule", "near", "past", "sky0", "sky1", "sky2", "sky3", "sky4", "meadow", "bark",
                    "twigs", "blossom0", "blossom1", "blossom2"];

/** Reads the numbers of all figures. */
function readFigures(run) {
    decimalSign = run.decimal;
    for (const figure of run.ghost ? [...run.figures, run.ghost] : run.figures) {
        for (const part of figure.parts) {
            for (const name of ["x", "y", "angle", "restX", "restY"])
                part[name] = part[name].map((at) => run.column(at, part.count));
            part.vx = velocities(part.restX, part.x, run.every);
            part.vy = velocities(part.restY, part.y, run.every);
            readDrawings(run, part);
        }
    }
    for (const name of ["handX", "handY"])
        run[name] = run[name] === undefined ? null : run.column(run[name], run.count);
    run.pullUnits = unitsOf(longestPulls(run), longestArrow);
    run.velocityUnits = unitsOf(largestSpeeds(run), longestVelocity);
}

/** Returns the velocities along one axis, px/frame: the file has only what they differ from the way since the frame before. */
function velocities(rests, places, every) {
    return rests.map((rest, point) =>
        rest.map((one, i) => one + (i > 0 ? (places[point][i] - places[point][i - 1]) / every : 0)));
}

/** Returns the part of a figure that shows frame `index` of the page, and the index in it. */
function partAt(figure, index) {
    const part = figure.parts.findLast((one) => one.first <= index) ?? figure.parts[0];
    return { part, i: Math.min(index - part.first, part.count - 1) };
}

/** Draws pictures on a canvas. */
class Painter {
    constructor(canvas, run) {
        this.canvas = canvas;
        this.run = run;
        this.pen = canvas.getContext("2d");
        this.camera = new Camera();
        this.stamps = new Map();
        this.shows = { ...run.shows }; // what the reader sees of the scene
        this.motion = matchMedia("(prefers-reduced-motion: reduce)");
        this.takeColors();
    }

    /** Reads the colours of the style sheet. */
    takeColors() {
        const style = getComputedStyle(document.documentElement);
        this.colors = Object.fromEntries(
            colorNames.map((name) => [name, style.getPropertyValue("--" + name).trim().toLowerCase()]));
        this.isDark = style.colorScheme === "dark";
        this.stamps.clear();
    }

    /** Gives the canvas the size that it has on the screen. Returns whether it is another one. */
    resize() {
        const { clientWidth, clientHeight } = this.canvas;
        const ratio = Math.min(3, window.devicePixelRatio || 1);
        if (clientWidth === this.camera.width && clientHeight === this.camera.height && ratio === this.ratio)
            return false;
        this.ratio = ratio;
        this.canvas.width = Math.round(clientWidth * ratio);
        this.canvas.height = Math.round(clientHeight * ratio);
        this.camera.width = clientWidth;
        this.camera.height = clientHeight;
        this.stamps.clear();
        return true;
    }

    sceneOf(figure, index) {
        const { part, i } = partAt(figure, index);
        return { part, i, pen: this.pen, camera: this.camera, colors: this.colors, isDark: this.isDark,
                 ratio: this.ratio, stamps: this.stamps, shiftX: figure.shiftX, shiftY: figure.shiftY,
                 every: this.run.every, index, frame: this.run.first + index * this.run.every,
                 pullUnit: this.run.pullUnits[index], velocityUnit: this.run.velocityUnits[index],
                 hasEyes: this.shows.eyes, font: "12px Inter, system-ui, sans-serif", labels: [],
                 isStill: this.motion.matches };
    }

    draw(index) {
        const { pen } = this;
        if (this.canvas.width === 0 || this.canvas.height === 0)
            return;
        pen.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
        const scenes = this.run.figures.map((figure) => this.sceneOf(figure, index));
        this.drawSurroundings(scenes);
        scenes.forEach((scene, k) => this.drawFigure(scene, this.run.figures[k], k === 0));
        const { handX, handY } = this.run;
        if (handX && Number.isFinite(handX[index]))
            drawHand(pen, this.colors, this.camera.at(handX[index], handY[index]));
    }

    /** Draws what does not move. While the view stays, it is a copy of a picture: the grid alone takes some milliseconds. */
    drawSurroundings(scenes) {
        const { x, y, zoom, width, height } = this.camera;
        const views = scenes.map((scene) => scene.part.view);
        const key = [x, y, zoom, width, height, this.ratio, this.shows.grid, this.colors, horizonOf(scenes[0]), ...views];
        if (this.key?.length !== key.length || key.some((one, k) => one !== this.key[k])) {
            this.key = key;
            this.kept = null; // a view that moves is not worth a copy
            this.drawSurroundingsWith(this.pen, scenes);
            return;
        }
        this.kept ??= { surroundings: this.paint(null, (pen) => this.drawSurroundingsWith(pen, scenes)), skins: [] };
        this.pen.drawImage(this.kept.surroundings, 0, 0, width, height);
    }

    /** Paints a picture of the size of the canvas: `picture` again, or a new one. Returns it. */
    paint(picture, draw) {
        const { width, height } = this.canvas;
        picture ??= Object.assign(document.createElement("canvas"), { width, height });
        const pen = picture.getContext("2d");
        pen.setTransform(1, 0, 0, 1, 0, 0);
        pen.clearRect(0, 0, width, height);
        pen.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
        draw(pen);
        return picture;
    }

    drawSurroundingsWith(pen, scenes) {
        const all = scenes.map((scene) => ({ ...scene, pen }));
        const [own] = all;
        if (own.part.view.dusk) {
            drawSky(own);
        } else {
            pen.fillStyle = this.colors.scene;
            pen.fillRect(0, 0, this.camera.width, this.camera.height);
            if (this.shows.grid)
                drawGrid(own);
        }
        all.forEach(drawRoom);
        drawRamps(own);
        drawGround(own);
    }

    drawFigure(scene, figure, isRun) {
        const view = scene.part.view;
        drawShadows(scene);
        if (isRun) {
            this.drawPast(scene, figure);
            drawTree(scene);
            drawMeadow(scene);
        }
        drawLimbs(scene);
        view.skins.forEach((skin) => drawSkin(scene, skin));
        drawSheets(scene);
        view.chains.forEach((chain) => drawChain(scene, chain));
        drawLegs(scene);
        drawSprings(scene);
        view.sticks.forEach((stick) => drawStick(scene, stick));
        drawRuleLinks(scene);
        this.pen.setLineDash([]);
        drawBodies(scene);
        this.drawMarks(scene, isRun);
        if (figure.name) {
            const [left, top] = view.stage;
            const place = this.camera.at(left + scene.shiftX, top + scene.shiftY);
            drawWords(scene, figure.name, place.x, place.y + 12, this.colors.ink, "600 " + scene.font);
        }
    }

    /** Draws the ghost, and where the figure has been. */
    drawPast(scene, figure) {
        this.ghost = this.shows.ghost ? ghostAt(this.run, scene.index) : null;
        if (this.ghost)
            drawGhost(scene, this.ghost);
        if (this.shows.onion)
            drawOnion(scene, figure, this);
        if (this.shows.trails)
            drawTrails(scene);
    }

    /** Draws what explains the figure. */
    drawMarks(scene, isRun) {
        const overlays = this.shows.guides ? overlaysAt(scene.part, scene.i) : [];
        scene.labels = boxesOfBodies(scene);
        scene.lines = linesToAvoid(scene, overlays);
        if (isRun && this.shows.unitCircle)
            scene.lines.push(...drawTriangle(scene));
        if (isRun && this.card)
            scene.labels.push(this.card);
        overlays.forEach((overlay) => drawOverlay(scene, overlay));
        if (isRun && this.shows.velocities)
            drawVelocities(scene);
    }
}
