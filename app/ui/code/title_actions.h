#pragma once

#include <QHBoxLayout>
#include <QPointer>
#include <QToolButton>

namespace app {

/// Buttons that a panel makes for its title. The title owns them once they are in it.
class TitleActions
{
public:
    TitleActions()
    {
        m_row->setContentsMargins(0, 0, 0, 0);
        m_row->setSpacing(8);
    }
    ~TitleActions()
    {
        if (m_widget && !m_widget->parent())
            delete m_widget;
    }
    TitleActions(const TitleActions &) = delete;
    TitleActions &operator=(const TitleActions &) = delete;

    QWidget *widget() const { return m_widget; }
    QToolButton *addButton(const QString &name = {}, const QString &text = {})
    {
        auto *button = new QToolButton;
        button->setObjectName(name);
        button->setText(text);
        button->setToolButtonStyle(text.isEmpty() ? Qt::ToolButtonIconOnly : Qt::ToolButtonTextBesideIcon);
        button->setIconSize({16, 16});
        button->setFixedHeight(28);
        button->setFocusPolicy(Qt::TabFocus);
        m_row->addWidget(button);
        return button;
    }

private:
    QPointer<QWidget> m_widget = new QWidget;
    QHBoxLayout *m_row = new QHBoxLayout(m_widget);
};

}
