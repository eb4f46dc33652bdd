#pragma once

#include "app/ui/theme/theme.h"

#include <QFocusFrame>

namespace app {

/// A ring round a control that a learner is asked to use. It goes where that goes, and takes no clicks.
class GuideRing : public QFocusFrame
{
    Q_OBJECT

public:
    /// The theme must outlive it.
    explicit GuideRing(const Theme &theme, QWidget *parent = nullptr);

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    const Theme &m_theme;
};

}
