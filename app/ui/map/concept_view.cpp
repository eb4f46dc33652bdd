#include "app/ui/map/concept_view.h"

#include "app/ui/map/concept_button.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace app {

namespace {

constexpr int leastGap = 8;     ///< px between two concepts side by side
constexpr int leastRowGap = 12; ///< px between two rows
constexpr int viewEdge = 4;     ///< px around the drawing, for the focus ring

std::vector<std::vector<std::size_t>> basesOf(const std::vector<ConceptNode> &nodes)
{
    std::vector<std::vector<std::size_t>> bases;
    for (const ConceptNode &node : nodes)
        bases.push_back(node.restsOn);
    return bases;
}

bool contains(const std::vector<std::size_t> &all, std::size_t one)
{
    return std::find(all.begin(), all.end(), one) != all.end();
}

}

ConceptView::ConceptView(const Theme &theme, QWidget *parent) : QWidget(parent), m_theme(theme)
{
    setAccessibleName(tr("Map of concepts"));
}

void ConceptView::setMap(const ConceptMap &map)
{
    m_lit.reset();
    qDeleteAll(m_buttons);
    m_buttons.clear();
    m_nodes = map.nodes();
    m_layout = layeredLayout(basesOf(m_nodes), mostInRow);
    m_width = ConceptButton::widthFor(m_nodes, m_theme);
    for (std::size_t i = 0; i < m_nodes.size(); ++i) {
        auto *made = new ConceptButton(m_nodes[i], m_theme, this);
        m_buttons.push_back(made);
        connect(made, &QAbstractButton::clicked, this, [this, i] { emit chosen(i); });
        connect(made, &ConceptButton::pointed, this, [this, i](bool on) {
            if (on)
                light(i);
            else if (m_lit == i)
                light({});
        });
        connect(made, &ConceptButton::arrowPressed, this, [this, i](int key) { moveFocus(i, key); });
        made->show();
    }
    std::vector<std::size_t> order(m_nodes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
        const LayeredLayout::Place &one = m_layout.nodes[a], &other = m_layout.nodes[b];
        return std::pair(one.row, one.x) < std::pair(other.row, other.x);
    });
    for (std::size_t i = 1; i < order.size(); ++i)
        setTabOrder(m_buttons[order[i - 1]], m_buttons[order[i]]);
    updateGeometry();
    place();
    emit litChanged();
}

void ConceptView::setStates(const std::vector<ConceptState> &states)
{
    for (std::size_t i = 0; i < std::min(states.size(), m_buttons.size()); ++i)
        m_buttons[i]->setState(states[i]);
}

QSize ConceptView::minimumSizeHint() const
{
    const int rows = std::max(1, m_layout.rows);
    return {static_cast<int>(std::ceil(m_layout.width * (m_width + leastGap))) + m_width + 2 * viewEdge,
            rows * ConceptButton::height + (rows - 1) * leastRowGap + 2 * viewEdge};
}

double ConceptView::rowHeight() const
{
    const double room = height() - 2 * viewEdge - ConceptButton::height;
    return m_layout.rows > 1 ? room / (m_layout.rows - 1) : 0.0;
}

QPointF ConceptView::pointOf(const LayeredLayout::Place &place) const
{
    const double room = width() - 2 * viewEdge - m_width;
    const double share = m_layout.width > 0.0 ? place.x / m_layout.width : 0.5;
    return {viewEdge + m_width / 2.0 + share * room,
            viewEdge + ConceptButton::height / 2.0 + place.row * rowHeight()};
}

void ConceptView::place()
{
    for (std::size_t i = 0; i < m_buttons.size(); ++i) {
        const QPointF centre = pointOf(m_layout.nodes[i]);
        m_buttons[i]->setGeometry(qRound(centre.x() - m_width / 2.0),
                                  qRound(centre.y() - ConceptButton::height / 2.0), m_width,
                                  ConceptButton::height);
    }
    update();
}

void ConceptView::resizeEvent(QResizeEvent *)
{
    place();
}

void ConceptView::light(std::optional<std::size_t> node)
{
    if (node == m_lit)
        return;
    m_lit = node;
    for (std::size_t i = 0; i < m_buttons.size(); ++i)
        m_buttons[i]->setFaded(m_lit && !isNear(i));
    update();
    emit litChanged();
}

bool ConceptView::isNear(std::size_t node) const
{
    return m_lit && (node == *m_lit || contains(m_nodes[*m_lit].restsOn, node) ||
                     contains(m_nodes[*m_lit].carries, node));
}

void ConceptView::moveFocus(std::size_t from, int key)
{
    const LayeredLayout::Place &now = m_layout.nodes[from];
    const bool isSideways = key == Qt::Key_Left || key == Qt::Key_Right;
    const int sign = key == Qt::Key_Right || key == Qt::Key_Down ? 1 : -1;
    std::optional<std::size_t> best;
    const auto distance = [&](std::size_t i) {
        const LayeredLayout::Place &there = m_layout.nodes[i];
        return std::pair(std::abs(there.row - now.row), std::abs(there.x - now.x));
    };
    for (std::size_t i = 0; i < m_nodes.size(); ++i) {
        const LayeredLayout::Place &there = m_layout.nodes[i];
        const bool fits = isSideways ? there.row == now.row && sign * (there.x - now.x) > 0.0
                                     : sign * (there.row - now.row) > 0;
        if (fits && (!best || distance(i) < distance(*best)))
            best = i;
    }
    if (best)
        m_buttons[*best]->setFocus(Qt::ShortcutFocusReason);
    else
        light(from); // the focus may be here without a light
}

QPainterPath ConceptView::pathOf(const LayeredLayout::Edge &edge) const
{
    const double half = ConceptButton::height / 2.0;
    QPainterPath path(pointOf(m_layout.nodes[edge.from]) + QPointF(0.0, half));
    const auto curveTo = [&path](QPointF to) {
        const QPointF from = path.currentPosition();
        const QPointF bend(0.0, (to.y() - from.y()) / 2.0);
        path.cubicTo(from + bend, to - bend, to);
    };
    for (const LayeredLayout::Place &place : edge.between) {
        const QPointF at = pointOf(place);
        curveTo(at - QPointF(0.0, half));
        path.lineTo(at + QPointF(0.0, half));
    }
    curveTo(pointOf(m_layout.nodes[edge.to]) - QPointF(0.0, half));
    return path;
}

void ConceptView::paintEvent(QPaintEvent *)
{
    const Tokens &tokens = m_theme.tokens();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    std::vector<const LayeredLayout::Edge *> lit;
    painter.setPen(QPen(m_lit ? tokens.line2 : tokens.ctl, 1.0));
    for (const LayeredLayout::Edge &edge : m_layout.edges) {
        if (m_lit && (edge.from == *m_lit || edge.to == *m_lit))
            lit.push_back(&edge);
        else
            painter.drawPath(pathOf(edge));
    }
    painter.setPen(QPen(tokens.ink, 2.0));
    for (const LayeredLayout::Edge *edge : lit)
        painter.drawPath(pathOf(*edge));
}

}
