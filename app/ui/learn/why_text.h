#pragma once

#include "app/ui/learn/narration_text.h"
#include "lessons/api/explanation.h"

#include <optional>
#include <vector>

namespace app {

/// The answer to a question. A formula under the mouse, or one reached with Tab, highlights its subjects in the scene. A
/// click or Enter keeps them highlighted.
class WhyText : public NarrationText
{
    Q_OBJECT

public:
    WhyText(const lessons::Why &why, const Theme &theme, QWidget *parent = nullptr);

    /// Returns the box of a formula in the viewport, px.
    QRect formulaBox(std::size_t formula) const;

signals:
    /// Emitted when other things are to be highlighted. Empty: nothing.
    void highlightsChanged(const std::vector<lessons::Highlight> &highlights);

protected:
    void decorate() override;
    bool focusNextPrevChild(bool next) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;

private:
    using Place = std::optional<std::size_t>; ///< of a formula in m_formulas

    Place formulaAt(QPoint place) const;
    Place formulaOfFocus() const;
    void keep(const QUrl &link);
    /// Highlights the formula under the mouse, otherwise the one with the focus, otherwise the one that is kept.
    void highlight();
    void markLine();

    const Theme &m_theme;
    std::vector<lessons::Formula> m_formulas;
    std::vector<int> m_blocks; ///< the numbers of their blocks in the document
    Place m_pointed, m_focused, m_kept;
    Place m_shown; ///< the one that is highlighted
};

}
