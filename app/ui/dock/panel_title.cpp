#include "app/ui/dock/panel_title.h"

#include "app/ui/dock/panel_parts.h"

#include <QButtonGroup>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace app {

PanelTitle::PanelTitle(const QString &title, const Theme &theme, QWidget *parent, CaptionPlace place)
    : QWidget(parent), m_title(new QLabel(title, this)), m_caption(new QLabel(this)),
      m_row(new QHBoxLayout(this))
{
    setObjectName("dockTitle");
    setAttribute(Qt::WA_StyledBackground);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_title->setObjectName("title");
    m_title->setFont(theme.ui(13, QFont::DemiBold));
    m_caption->setObjectName("caption");
    m_caption->setFont(theme.ui(12));
    m_caption->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_caption->setAlignment(place == CaptionPlace::right ? Qt::AlignRight | Qt::AlignVCenter
                                                         : Qt::AlignLeft | Qt::AlignVCenter);
    m_row->setContentsMargins(16, 4, 12, 4);
    m_row->setSpacing(8);
    m_row->addWidget(m_title);
    m_row->addWidget(m_caption, 1);
}

void PanelTitle::setShortCaption(const QString &caption)
{
    m_shortCaption = caption;
    fitCaption();
}

QString PanelTitle::caption() const
{
    return m_captionText;
}

void PanelTitle::setCaption(const QString &caption)
{
    m_captionText = caption;
    m_caption->setAccessibleName(caption);
    fit();
}

void PanelTitle::addTabs(QWidget *tabs)
{
    m_tabs = tabs;
    m_row->insertWidget(m_row->indexOf(m_caption), tabs, 0, Qt::AlignVCenter);
}

void PanelTitle::addAction(QWidget *widget)
{
    m_row->addWidget(widget, 0, Qt::AlignVCenter);
}

void PanelTitle::fitCaption()
{
    const QFontMetrics metrics = m_caption->fontMetrics();
    QString fitting = metrics.elidedText(m_captionText, Qt::ElideRight, m_caption->width());
    const bool hasTabs = m_tabs && !m_tabs->isHidden();
    if (fitting != m_captionText && (hasTabs || !m_shortCaption.isEmpty()))
        fitting =
            metrics.horizontalAdvance(m_shortCaption) <= m_caption->width() ? m_shortCaption : QString();
    m_caption->setText(fitting);
    m_caption->setToolTip(fitting == m_captionText ? QString() : m_captionText);
}

bool PanelTitle::event(QEvent *event)
{
    const bool isDone = QWidget::event(event);
    if (event->type() == QEvent::LayoutRequest)
        fit(); // tabs or actions have come, gone or changed
    return isDone;
}

void PanelTitle::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    fit();
}

void PanelTitle::fit()
{
    // The actions take precedence, because the tab also shows the panel's name. So do captions beside tabs.
    const int caption =
        m_tabs && !m_tabs->isHidden() ? m_caption->fontMetrics().horizontalAdvance(m_captionText) : 0;
    const int needed = m_row->minimumSize().width() + caption +
                       (m_title->isHidden() ? m_title->minimumSizeHint().width() + m_row->spacing() : 0);
    m_title->setVisible(needed <= width());
    m_row->activate();
    fitCaption();
}

QSize PanelTitle::sizeHint() const
{
    return {QWidget::sizeHint().width(), height};
}

QSize PanelTitle::minimumSizeHint() const
{
    // Beside tabs, the title gives way in a narrow panel.
    const int title =
        m_tabs && !m_title->isHidden() ? m_title->minimumSizeHint().width() + m_row->spacing() : 0;
    return {QWidget::minimumSizeHint().width() - title, height};
}

QToolButton *makeTab(const QString &text, const QString &tip, QWidget *parent)
{
    auto *tab = new QToolButton(parent);
    tab->setObjectName("tab");
    tab->setText(text);
    tab->setToolTip(tip);
    tab->setCheckable(true);
    tab->setFocusPolicy(Qt::TabFocus);
    return tab;
}

QButtonGroup *makeTabs(std::initializer_list<Tab> tabs, QWidget *row)
{
    QHBoxLayout *layout = makeRow(row, 2);
    auto *group = new QButtonGroup(row);
    for (const Tab &tab : tabs) {
        QToolButton *button = makeTab(tab.text, tab.tip, row);
        button->setChecked(group->buttons().isEmpty());
        group->addButton(button, layout->count());
        layout->addWidget(button);
    }
    return group;
}

}
