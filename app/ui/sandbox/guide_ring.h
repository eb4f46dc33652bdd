#pragma once

#include "app/ui/theme/theme.h"

#include <QFocusFrame>

namespace app {

/// A ring round a control that the guide asks the learner to use. It follows the control and ignores clicks.
class GuideRing : public QFocusFrame
{
    Q_OBJECT

public:
    /// The theme must outlive the ring.
    explicit GuideRing(const Theme &theme, QWidget *parent = nullptr);

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    const Theme &m_theme;
};

}
