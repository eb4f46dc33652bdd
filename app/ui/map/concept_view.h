#pragma once

#include "app/model/learning/concept_map.h"
#include "app/model/learning/layered_layout.h"
#include "app/ui/theme/theme.h"

#include <QPainterPath>
#include <QWidget>

#include <optional>
#include <vector>

namespace app {

class ConceptButton;

/// The drawing of the map: concepts in rows, each below those that it rests on, with lines between them. A concept that the
/// pointer or the keyboard is on lights up with those that it rests on and those that rest on it.
class ConceptView : public QWidget
{
    Q_OBJECT

public:
    static constexpr int mostInRow = 5; ///< concepts side by side, which fit into a window of 1280 px

    ConceptView(const Theme &theme, QWidget *parent = nullptr);

    void setMap(const ConceptMap &map);
    void setStates(const std::vector<ConceptState> &states);
    const std::vector<ConceptNode> &nodes() const { return m_nodes; }
    ConceptButton &button(std::size_t node) const { return *m_buttons[node]; }
    /// Returns the concept that is lit; empty if none is.
    std::optional<std::size_t> lit() const { return m_lit; }
    const LayeredLayout &plan() const { return m_layout; }
    QSize minimumSizeHint() const override;
    QSize sizeHint() const override { return minimumSizeHint(); }

signals:
    /// Emitted when the learner chooses a concept.
    void chosen(std::size_t node);
    /// Another concept is lit, or none.
    void litChanged();

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void light(std::optional<std::size_t> node);
    void moveFocus(std::size_t from, int key);
    void place();
    /// Returns whether `node` is lit, or joined with the one that is.
    bool isNear(std::size_t node) const;
    QPointF pointOf(const LayeredLayout::Place &place) const;
    QPainterPath pathOf(const LayeredLayout::Edge &edge) const;
    double rowHeight() const;

    const Theme &m_theme;
    std::vector<ConceptNode> m_nodes;
    LayeredLayout m_layout;
    std::vector<ConceptButton *> m_buttons;
    int m_width = 0; ///< px, of each concept
    std::optional<std::size_t> m_lit;
};

}
