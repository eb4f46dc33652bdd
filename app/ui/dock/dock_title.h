#pragma once

#include "app/ui/dock/panel_title.h"

namespace app {

/// The title bar of a dock, for QDockWidget::setTitleBarWidget.
class DockTitle : public PanelTitle
{
    Q_OBJECT

public:
    DockTitle(const QString &title, const Theme &theme, QWidget *parent = nullptr)
        : PanelTitle(title, CaptionPlace::besideTitle, theme, parent)
    {
    }
};

}
