#include "app/model/web/page_view.h"

#include "app/model/text/json_writer.h"
#include "sim/effects/contacts/ramp.h"

namespace app {

namespace {

/// Writes a list of objects, with their fields by `write`.
template <class Items, class Write>
void writeObjects(JsonWriter &json, const QString &name, const Items &items, const Write &write)
{
    json.beginList(name);
    for (const auto &item : items) {
        json.beginObject();
        write(item);
        json.endObject();
    }
    json.endList();
}

void writePlace(JsonWriter &json, const QString &name, sim::Vec2 place)
{
    json.list(name, std::array{place.x, place.y});
}

QString nameOf(lessons::BodyView::Shape shape)
{
    using Shape = lessons::BodyView::Shape;
    switch (shape) {
    case Shape::body:
        return QStringLiteral("body");
    case Shape::foot:
        return QStringLiteral("foot");
    case Shape::joint:
        return QStringLiteral("joint");
    case Shape::none:
        break;
    }
    return QStringLiteral("none");
}

QString nameOf(lessons::SpringView::Part part)
{
    using Part = lessons::SpringView::Part;
    switch (part) {
    case Part::inside:
        return QStringLiteral("inside");
    case Part::edge:
        return QStringLiteral("edge");
    case Part::alone:
        break;
    }
    return QStringLiteral("alone");
}

void writePoints(JsonWriter &json, const lessons::View &view)
{
    writeObjects(json, "bodies", view.bodies, [&](const lessons::BodyView &body) {
        json.field("shape", nameOf(body.shape));
        json.field("radius", body.radius);
        if (body.fixed)
            json.field("fixed", true);
    });
}

void writeLinks(JsonWriter &json, const lessons::View &view)
{
    writeObjects(json, "legs", view.legs, [&](const lessons::LegView &leg) {
        json.field("from", leg.from);
        json.field("to", leg.to);
        json.field("curve", leg.curve);
    });
    writeObjects(json, "sticks", view.sticks, [&](const lessons::StickView &stick) {
        json.field("a", stick.a);
        json.field("b", stick.b);
        json.field("length", stick.length);
        json.field("width", stick.width);
    });
    writeObjects(json, "springs", view.springs, [&](const lessons::SpringView &spring) {
        json.field("a", spring.a);
        json.field("b", spring.b);
        json.field("length", spring.length);
        writePlace(json, "at", spring.at);
        json.field("part", nameOf(spring.part));
    });
    writeObjects(json, "limbs", view.limbs, [&](const lessons::LimbView &limb) {
        json.field("a", limb.a);
        json.field("b", limb.b);
        json.field("width", limb.width);
    });
    writeObjects(json, "ruleLinks", view.ruleLinks, [&](const lessons::RuleLinkView &link) {
        json.field("a", link.a);
        json.field("b", link.b);
    });
}

void writeShapes(JsonWriter &json, const lessons::View &view)
{
    writeObjects(json, "chains", view.chains, [&](const lessons::ChainView &chain) {
        json.list("points", chain.points);
        json.field("width", chain.width);
    });
    writeObjects(json, "skins", view.skins, [&](const lessons::SkinView &skin) {
        json.list("outline", skin.outline);
        json.field("front", skin.front);
    });
    json.beginList("sheets");
    for (const lessons::SheetView &sheet : view.sheets) {
        json.beginList();
        for (const int corner : sheet.corners)
            json.value(corner);
        json.endList();
    }
    json.endList();
    if (!view.tree)
        return;
    json.beginObject("tree");
    json.list("parent", view.tree->parent);
    json.list("length", view.tree->length);
    json.list("width", view.tree->width);
    json.endObject();
}

void writeSurroundings(JsonWriter &json, const lessons::View &view, const sim::Scene &scene)
{
    if (view.room) {
        json.beginObject("room");
        json.field("left", view.room->left);
        json.field("right", view.room->right);
        json.field("floor", view.room->floor);
        json.endObject();
    }
    if (view.ground)
        json.field("ground", *view.ground);
    json.list("stage",
              std::array{view.stage.left(), view.stage.top(), view.stage.width(), view.stage.height()});
    json.field("dusk", view.sky == lessons::View::Sky::dusk);
    json.field("followed", view.followedPoint);
    if (view.angle) {
        json.beginObject("angle");
        json.field("from", view.angle->from);
        json.field("to", view.angle->to);
        json.endObject();
    }
    json.beginList("ramps");
    for (const sim::EffectPtr &effect : scene.effects) {
        const auto *ramp = dynamic_cast<const sim::Ramp *>(effect.get());
        if (!ramp)
            continue;
        json.beginObject();
        writePlace(json, "through", ramp->edge().through);
        writePlace(json, "normal", ramp->edge().normal);
        json.endObject();
    }
    json.endList();
}

}

void writeView(JsonWriter &json, const lessons::View &view, const sim::Scene &scene)
{
    json.beginObject(JsonWriter::Layout::oneLine);
    writePoints(json, view);
    writeLinks(json, view);
    writeShapes(json, view);
    writeSurroundings(json, view, scene);
    json.endObject();
}

}
