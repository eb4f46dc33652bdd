#include "app/ui/effects/effect_list.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

namespace app {

namespace {

struct Head
{
    double left;
    double right;
    Qt::Alignment side;
    QString title;
    QString help;
};

std::vector<Head> headsFor(double width)
{
    const EffectColumns c(width);
    std::vector<Head> heads = {
        {c.name, c.name + c.nameWidth, Qt::AlignLeft, EffectHeads::tr("Effect"),
         EffectHeads::tr("What acts in this scene, in the order in which it runs.")},
        {c.frameRight - 74.0, c.frameRight, Qt::AlignRight, EffectHeads::tr("µs a frame"),
         EffectHeads::tr(
             "Microseconds, millionths of a second, that each frame of the run spends on it. ± is how "
             "far half of the rounds are apart.")},
        {c.pointRight - 64.0, c.pointRight, Qt::AlignRight, EffectHeads::tr("µs a point"),
         EffectHeads::tr("The same for each point that it works on.")},
        {c.runsRight - 40.0, c.runsRight, Qt::AlignRight, EffectHeads::tr("runs"),
         EffectHeads::tr("How often a frame computes it: some methods look several times.")},
    };
    if (c.hasPoints)
        heads.push_back({c.pointsRight - 50.0, c.pointsRight, Qt::AlignRight, EffectHeads::tr("points"),
                         EffectHeads::tr("How many points it works on.")});
    return heads;
}

}

EffectHeads::EffectHeads(const Theme &theme, const EffectList &list, QWidget *parent)
    : QWidget(parent), m_theme(theme), m_list(list)
{
    setFixedHeight(headHeight);
    connect(&theme, &Theme::changed, this, qOverload<>(&QWidget::update));
}

void EffectHeads::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setFont(m_theme.ui(12));
    painter.setPen(m_theme.tokens().ink3);
    for (const Head &head : headsFor(m_list.viewport()->width())) {
        const QRectF box(head.left, 0.0, head.right - head.left, height());
        painter.drawText(box, int(head.side | Qt::AlignVCenter | Qt::TextDontClip), head.title);
    }
}

bool EffectHeads::event(QEvent *event)
{
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto *help = static_cast<QHelpEvent *>(event);
    for (const Head &head : headsFor(m_list.viewport()->width())) {
        if (help->pos().x() >= head.left && help->pos().x() <= head.right) {
            QToolTip::showText(help->globalPos(), head.help, this);
            return true;
        }
    }
    QToolTip::hideText();
    return true;
}

}
