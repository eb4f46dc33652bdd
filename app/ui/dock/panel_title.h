#pragma once

#include "app/ui/theme/theme.h"

#include <QWidget>

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

    PanelTitle(const QString &title, CaptionPlace place, const Theme &theme, QWidget *parent = nullptr);

    void setTitle(const QString &title);
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
    void applyTheme();
    void fit();
    void fitCaption();
    bool event(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

    const Theme &m_theme;
    QLabel *m_title;
    QLabel *m_caption;
    QString m_captionText;
    QString m_shortCaption;
    QWidget *m_tabs = nullptr;
    QHBoxLayout *m_row;
};

/// Returns a checkable button that looks like a tab, for the title row of a panel.
QToolButton *makeTab(const QString &text, const QString &tip, QWidget *parent);

}
