#pragma once

#include <QProgressBar>

namespace app {

/// A thin progress bar without text. It repaints with the rest of the window, because QProgressBar repaints
/// at once, in the middle of a change.
class ProgressLine : public QProgressBar
{
public:
    /// `name` tells screen readers what progress the bar shows.
    ProgressLine(const QString &name, QWidget *parent);

    /// Sets the progress, from 0 to 1.
    void setShare(double share);

private:
    using QProgressBar::setValue;
};

}
