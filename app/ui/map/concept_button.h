#pragma once

#include "app/model/learning/concept_map.h"
#include "app/ui/theme/theme.h"

#include <QPushButton>

namespace app {

/// Paints the box of a concept: filled and with a tick if it is known, with a strong outline if it can come next, dashed if it
/// is for later. `strength` is 1, or less if the box is in the background.
void paintConcept(QPainter &painter, const QRectF &box, const QString &title, ConceptState state,
                  double strength, const Theme &theme);

/// A concept in the map. A click, Space or Enter opens its step.
class ConceptButton : public QPushButton
{
    Q_OBJECT

public:
    static constexpr int height = 32; ///< px

    ConceptButton(const ConceptNode &node, const Theme &theme, QWidget *parent);

    void setState(ConceptState state);
    ConceptState state() const { return m_state; }
    /// Draws it in the background, because another concept is pointed at.
    void setFaded(bool faded);
    bool isFaded() const { return m_isFaded; }
    /// Returns the width that shows the longest of `titles`, px.
    static int widthFor(const std::vector<ConceptNode> &nodes, const Theme &theme);
    QSize sizeHint() const override;

signals:
    /// The pointer or the keyboard came to this concept, or left it.
    void pointed(bool on);
    /// The learner pressed an arrow key.
    void arrowPressed(int key);

protected:
    void paintEvent(QPaintEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void enterEvent(QEnterEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    const Theme &m_theme;
    ConceptState m_state = ConceptState::later;
    bool m_isFaded = false;
};

}
