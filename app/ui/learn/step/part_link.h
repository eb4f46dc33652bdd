#pragma once

#include <QToolButton>

#include <algorithm>
#include <vector>

namespace app {

/// A button that goes to boxes further down in the text of a step. It is visible while none of these boxes is in view.
class PartLink : public QToolButton
{
    Q_OBJECT

public:
    PartLink(const QString &text, const QString &tip, QWidget *parent);

    /// Sets whether the button keeps its place while it is hidden, so that the text does not jump when it is scrolled.
    void keepPlace(bool isKept);
    bool keepsPlace() const { return sizePolicy().retainSizeWhenHidden(); }

    /// Shows the button if there are `boxes`, and the title of none of them is in `view`, an ancestor of theirs.
    template <class Box>
    void offer(const std::vector<Box *> &boxes, const QWidget *view)
    {
        const auto isInView = [view](const Box *box) { return isTitleIn(*view, *box); };
        setVisible(!boxes.empty() && std::none_of(boxes.begin(), boxes.end(), isInView));
    }

private:
    static bool isTitleIn(const QWidget &view, const QWidget &box);
};

}
