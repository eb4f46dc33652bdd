#include "app/ui/dialogs/notice.h"

#include "app/ui/dock/panel_parts.h"
#include "app/ui/theme/icon_button.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

namespace app {

Notice::Notice(const Theme &theme, QWidget *parent)
    : QFrame(parent), m_text(new QLabel(this)), m_choices(new QWidget(this)), m_row(new QHBoxLayout(this)),
      m_close(new QToolButton(this))
{
    setObjectName("notice");
    setAccessibleName(tr("Notice"));
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_close->setFocusPolicy(Qt::TabFocus);
    m_close->setToolTip(tr("Close this notice (Esc)"));
    m_close->setAccessibleName(tr("Close this notice"));
    m_close->setShortcut(Qt::Key_Escape);
    m_row->setContentsMargins(16, 6, 8, 6);
    m_row->setSpacing(8);
    m_row->addWidget(m_text, 1);
    m_row->addWidget(m_choices);
    m_row->addWidget(m_close);
    connect(m_close, &QToolButton::clicked, this, [this] { showMessage({}); });
    showIcon(*m_close, "close", theme);
    m_close->setIconSize({16, 16});
    hide();
    window()->installEventFilter(this);
}

bool Notice::eventFilter(QObject *watched, QEvent *event)
{
    // A field gets keys before shortcuts do. If it ignores Esc, the key reaches the window in the end.
    if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent *>(event)->key() == Qt::Key_Escape &&
        isVisible()) {
        showMessage({});
        return true;
    }
    return QFrame::eventFilter(watched, event);
}

void Notice::showMessage(const QString &sentence)
{
    ask(sentence, {});
}

void Notice::ask(const QString &sentence, const std::vector<Choice> &choices)
{
    m_text->setText(sentence);
    m_text->setAccessibleName(sentence);
    showChoices(choices);
    setVisible(!sentence.isEmpty());
}

void Notice::showChoices(const std::vector<Choice> &choices)
{
    delete m_choices;
    m_choices = new QWidget(this);
    m_row->insertWidget(1, m_choices);
    QHBoxLayout *row = makeRow(m_choices, 8);
    for (const Choice &choice : choices) {
        auto *button = new QPushButton(choice.text, m_choices);
        button->setToolTip(choice.help);
        button->setAccessibleDescription(choice.help);
        button->setFocusPolicy(Qt::TabFocus);
        row->addWidget(button);
        // Queued, because the slot deletes the button that emits the signal.
        connect(
            button, &QPushButton::clicked, this,
            [this, take = choice.take] {
                showMessage({});
                take();
            },
            Qt::QueuedConnection);
    }
    m_choices->setVisible(!choices.empty());
}

QString Notice::sentence() const
{
    return m_text->text();
}

}
