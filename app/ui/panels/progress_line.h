#pragma once

#include <QProgressBar>

namespace app {

/// A thin bar without a text that tells how far something is. It is painted with all else: QProgressBar itself paints at
/// once, in the middle of a change.
class ProgressLine : public QProgressBar
{
public:
    /// `name` tells readers of the screen what it is about.
    ProgressLine(const QString &name, QWidget *parent);

    /// From 0 to 1.
    void setShare(double share);

private:
    using QProgressBar::setValue;
};

}
