#include "app/ui/code/listing/mistake_row.h"

#include "app/ui/dock/divider.h"
#include "app/ui/dock/panel_parts.h"

#include <QLabel>
#include <QVBoxLayout>

namespace app {

MistakeRow::MistakeRow(QWidget *parent) : QWidget(parent), m_sentence(new QLabel(this))
{
    constexpr int sideMargin = 16;
    m_sentence->setObjectName("failure");
    m_sentence->setTextFormat(Qt::PlainText);
    m_sentence->setWordWrap(true);
    m_sentence->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto *room = new QVBoxLayout;
    room->setContentsMargins(sideMargin, 6, sideMargin, 8);
    room->addWidget(m_sentence);
    QVBoxLayout *column = makeColumn(this);
    column->addWidget(divider(this));
    column->addLayout(room);
    hide();
}

QString MistakeRow::sentence() const
{
    return isHidden() ? QString() : m_sentence->text();
}

void MistakeRow::setSentence(const QString &sentence)
{
    m_sentence->setText(sentence);
    setVisible(!sentence.isEmpty());
}

QString mistakeSentence(const std::vector<CodeMistake> &mistakes)
{
    if (mistakes.empty())
        return {};
    return MistakeRow::tr("Line %1: %2").arg(mistakes.front().line).arg(mistakes.front().sentence);
}

}
