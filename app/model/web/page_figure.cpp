#include "app/model/web/page_figure.h"

#include "app/model/text/json_writer.h"
#include "app/model/web/page_view.h"

#include <algorithm>

namespace app {

namespace {

constexpr int angleBits = 16;    ///< of degrees
constexpr int velocityBits = 14; ///< of px/frame
constexpr int overlayBits = 10;  ///< of px, and of rad
constexpr std::size_t perOverlay = 6;

QByteArray textOf(const Picture &picture)
{
    JsonWriter json(0);
    writeView(json, *picture.view, picture.interval->scene);
    return json.text();
}

QString nameOf(lessons::Overlay::Shape shape)
{
    using Shape = lessons::Overlay::Shape;
    switch (shape) {
    case Shape::cross:
        return QStringLiteral("cross");
    case Shape::ring:
        return QStringLiteral("ring");
    case Shape::arrow:
        return QStringLiteral("arrow");
    case Shape::line:
        return QStringLiteral("line");
    case Shape::angle:
        return QStringLiteral("angle");
    case Shape::wind:
        break;
    }
    return QStringLiteral("wind");
}

template <class Numbers>
void writeColumns(JsonWriter &json, NumberColumns &columns, const QString &name, const Numbers &numbers,
                  int bits)
{
    json.beginList(name);
    for (const auto &column : numbers)
        json.value(columns.addRounded(column, bits));
    json.endList();
}

}

PageFigure::Part &PageFigure::partFor(const Picture &picture)
{
    if (!m_parts.empty() && m_parts.back().view == picture.view)
        return m_parts.back();
    QByteArray text = textOf(picture);
    if (!m_parts.empty() && m_parts.back().viewText == text &&
        m_parts.back().interval->scene.names == picture.interval->scene.names) {
        m_parts.back().view = picture.view;
        return m_parts.back();
    }
    const auto points = static_cast<std::size_t>(picture.state.pointCount());
    const std::size_t branches = picture.view->tree ? points : 0;
    m_parts.push_back({m_count,
                       0,
                       picture.interval,
                       picture.view,
                       std::move(text),
                       std::vector<Column>(points),
                       std::vector<Column>(points),
                       std::vector<Column>(branches),
                       {},
                       {},
                       {}});
    return m_parts.back();
}

void PageFigure::add(const Picture &picture)
{
    Part &part = partFor(picture);
    const sim::State &state = picture.state;
    for (int i = 0; i < state.pointCount(); ++i) {
        const auto row = static_cast<std::size_t>(i);
        const sim::Vec2 at = state.positionOf(i);
        part.x[row].push_back(at.x);
        part.y[row].push_back(at.y);
        if (row < part.angle.size())
            part.angle[row].push_back(state.angle.rows() > i ? state.angle[i] : 0.0);
    }
    addDrawings(part, picture.overlays);
    ++part.count;
    ++m_count;
    m_places += state.pointCount() + static_cast<std::int64_t>(picture.overlays.size());
}

void PageFigure::addVelocities(const sim::State &state, int frames)
{
    if (state.pointCount() > mostWithVelocities)
        return;
    Part &part = m_parts.back();
    part.restX.resize(part.x.size());
    part.restY.resize(part.y.size());
    // Most methods move each point by its velocity. Then nothing is left here, which takes no room in the file.
    const auto way = [frames](const Column &places) {
        return places.size() > 1 ? (places.back() - places[places.size() - 2]) / frames : 0.0;
    };
    for (int i = 0; i < state.pointCount(); ++i) {
        const auto row = static_cast<std::size_t>(i);
        const bool isShown = part.view->bodies[row].shape != lessons::BodyView::Shape::none;
        const sim::Vec2 velocity = state.velocityOf(i);
        part.restX[row].push_back(isShown ? velocity.x - way(part.x[row]) : 0.0);
        part.restY[row].push_back(isShown ? velocity.y - way(part.y[row]) : 0.0);
    }
}

void PageFigure::addDrawings(Part &part, const std::vector<lessons::Overlay> &overlays)
{
    std::vector<lessons::Overlay::Shape> shapes;
    for (const lessons::Overlay &overlay : overlays)
        shapes.push_back(overlay.shape);
    if (part.drawings.empty() || part.drawings.back().shapes != shapes)
        part.drawings.push_back({part.count, shapes, {}, std::vector<Column>(perOverlay * shapes.size())});
    Drawings &drawings = part.drawings.back();
    for (std::size_t i = 0; i < overlays.size(); ++i) {
        const lessons::Overlay &overlay = overlays[i];
        const auto known = std::find(drawings.labels.begin(), drawings.labels.end(), overlay.label);
        const auto label = static_cast<double>(known - drawings.labels.begin());
        if (known == drawings.labels.end())
            drawings.labels.push_back(overlay.label);
        const double numbers[perOverlay] = {label,       overlay.a.x, overlay.a.y,
                                            overlay.b.x, overlay.b.y, overlay.size};
        for (std::size_t k = 0; k < perOverlay; ++k)
            drawings.numbers[perOverlay * i + k].push_back(numbers[k]);
    }
}

void PageFigure::writePart(JsonWriter &json, NumberColumns &columns, const Part &part)
{
    json.beginObject(JsonWriter::Layout::oneLine);
    json.field("first", part.first);
    json.field("count", part.count);
    json.list("names", part.interval->scene.names);
    json.name("view");
    writeView(json, *part.view, part.interval->scene);
    writeColumns(json, columns, "x", part.x, positionBits);
    writeColumns(json, columns, "y", part.y, positionBits);
    writeColumns(json, columns, "angle", part.angle, angleBits);
    writeColumns(json, columns, "restX", part.restX, velocityBits);
    writeColumns(json, columns, "restY", part.restY, velocityBits);
    json.beginList("drawings");
    for (const Drawings &drawings : part.drawings) {
        json.beginObject();
        json.field("first", drawings.first);
        json.beginList("shapes");
        for (const lessons::Overlay::Shape shape : drawings.shapes)
            json.value(nameOf(shape));
        json.endList();
        json.list("labels", drawings.labels);
        writeColumns(json, columns, "numbers", drawings.numbers, overlayBits);
        json.endObject();
    }
    json.endList();
    json.endObject();
}

void PageFigure::write(JsonWriter &json, NumberColumns &columns) const
{
    json.beginList("parts");
    for (const Part &part : m_parts)
        writePart(json, columns, part);
    json.endList();
}

}
