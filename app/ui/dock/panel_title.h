#pragma once

#include "app/ui/theme/theme.h"

#include <QWidget>

#include <initializer_list>

class QButtonGroup;
class QHBoxLayout;
class QLabel;
class QToolButton;

namespace app {

/// The title row of a panel, 36 px high: a bold title, a caption, and actions on the right.
class PanelTitle : public QWidget
{
    Q_OBJECT

public:
    static constexpr int height = 36;
    enum class CaptionPlace { besideTitle, right };

    PanelTitle(const QString &title, const Theme &theme, QWidget *parent = nullptr,
               CaptionPlace place = CaptionPlace::besideTitle);

    QString caption() const;
    void setCaption(const QString &caption);
    /// Sets what is shown if there is no room for the caption. If that does not fit either, nothing is. Beside tabs nothing is
    /// shown without it, and elsewhere a part of the caption.
    void setShortCaption(const QString &caption);
    /// Adds tabs behind the title.
    void addTabs(QWidget *tabs);
    /// Adds a widget at the right end.
    void addAction(QWidget *widget);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

private:
    void fit();
    void fitCaption();
    bool event(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

    QLabel *m_title;
    QLabel *m_caption;
    QString m_captionText;
    QString m_shortCaption;
    QWidget *m_tabs = nullptr;
    QHBoxLayout *m_row;
};

/// Returns a checkable button that looks like a tab, for the title row of a panel.
QToolButton *makeTab(const QString &text, const QString &tip, QWidget *parent);

/// The text and the tooltip of a tab.
struct Tab
{
    QString text;
    QString tip;
};

/// Puts tabs into `row`, a widget that is still empty. Returns their group, which belongs to `row`. One tab at a time is
/// checked, the first one at first. Their ids count from 0.
QButtonGroup *makeTabs(std::initializer_list<Tab> tabs, QWidget *row);

}
