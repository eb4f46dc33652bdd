// Draws one picture of the run.

const colorNames = ["scene", "win", "line2", "ink", "ink2", "ink3", "body", "bodyInk", "ghost", "dots", "spring", "contact",
                    "wind", "stick", "rule", "near", "past", "sky0", "sky1", "sky2", "sky3", "sky4", "meadow", "bark",
                    "twigs", "blossom0", "blossom1", "blossom2"];

/** Reads the numbers of all figures. */
function readFigures(run) {
    for (const figure of run.figures) {
        for (const part of figure.parts) {
            for (const name of ["x", "y", "angle"])
                part[name] = part[name].map((at) => run.column(at, part.count));
            readDrawings(run, part);
        }
    }
    for (const name of ["handX", "handY"])
        run[name] = run[name] === undefined ? null : run.column(run[name], run.count);
    run.unit = arrowUnit(run.figures.flatMap((figure) => figure.parts));
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
        this.showsTrails = true;
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
                 every: this.run.every, frame: this.run.first + index * this.run.every, unit: this.run.unit,
                 font: "12px Inter, system-ui, sans-serif", labels: [],
                 isStill: matchMedia("(prefers-reduced-motion: reduce)").matches };
    }

    draw(index) {
        const pen = this.pen;
        pen.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
        this.run.figures.forEach((figure, k) => {
            const scene = this.sceneOf(figure, index);
            if (k === 0)
                this.drawBackground(scene);
            this.drawFigure(scene, figure, k === 0);
        });
        const { handX, handY } = this.run;
        if (handX && Number.isFinite(handX[index]))
            drawHand(pen, this.colors, this.camera.at(handX[index], handY[index]));
    }

    drawBackground(scene) {
        if (scene.part.view.dusk) {
            drawSky(scene);
            return;
        }
        this.pen.fillStyle = this.colors.scene;
        this.pen.fillRect(0, 0, this.camera.width, this.camera.height);
        drawGrid(scene);
    }

    drawFigure(scene, figure, isRun) {
        const view = scene.part.view;
        drawRoom(scene);
        if (isRun) {
            drawRamps(scene);
            drawGround(scene);
        }
        drawShadows(scene);
        if (isRun) {
            if (this.showsTrails)
                drawTrails(scene);
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
        scene.labels = boxesOfBodies(scene);
        overlaysAt(scene.part, scene.i).forEach((overlay) => drawOverlay(scene, overlay));
        if (figure.name) {
            const [left, top] = view.stage;
            const place = this.camera.at(left + scene.shiftX, top + scene.shiftY);
            drawWords(scene, figure.name, place.x, place.y + 12, this.colors.ink, "600 " + scene.font);
        }
    }
}
