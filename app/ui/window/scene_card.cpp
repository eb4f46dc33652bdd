#include "app/ui/window/scene_card.h"

#include "app/model/catalog/progress.h"
#include "app/model/session/open_run.h"
#include "app/model/text/phrases.h"
#include "app/ui/actions/command.h"
#include "app/ui/learn/prose.h"
#include "app/ui/scene/hud/free_area.h"
#include "app/ui/scene/scene_view.h"

#include <QEvent>
#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>

#include <algorithm>

namespace app {

namespace {

constexpr int cardGap = 20;    ///< px, to the edges of the scene
constexpr int cardWidth = 420; ///< px
constexpr double cardRadius = 10.0;
constexpr double cover = 0.86; ///< opacity

/// Returns the first sentence of a text.
QString firstSentence(const QString &text)
{
    const QString line = text.section('\n', 0, 0, QString::SectionSkipEmpty);
    const qsizetype end = line.indexOf(QStringLiteral(". "));
    return end < 0 ? line : line.left(end + 1);
}

}

SceneCard::SceneCard(const OpenRun &run, const Progress &progress, const Command &nextStep,
                     const Theme &theme, SceneView &scene)
    : QFrame(&scene), m_run(run), m_progress(progress), m_nextKeys(nextStep.shortcut()), m_theme(theme),
      m_scene(scene), m_title(new QLabel(this)), m_text(new QLabel(this))
{
    setObjectName("sceneCard");
    setAttribute(Qt::WA_TransparentForMouseEvents);
    for (QLabel *label : {m_title, m_text}) {
        label->setTextFormat(Qt::PlainText);
        label->setWordWrap(true);
    }
    m_title->setFont(theme.ui(15, QFont::DemiBold));
    m_text->setFont(theme.ui(13));
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(16, 10, 16, 12);
    column->setSpacing(4);
    column->addWidget(m_title);
    column->addWidget(m_text);
    run.onChange(ChangeKind::step | ChangeKind::texts, this, &SceneCard::refresh);
    run.onChange(ChangeKind::cursor, this, &SceneCard::place);
    connect(&progress, &Progress::changed, this, &SceneCard::refresh);
    scene.installEventFilter(this);
    refresh();
}

QString SceneCard::sentence() const
{
    const lessons::Step &step = m_run.step();
    for (std::size_t i = 0; i < step.tries.size(); ++i) {
        if (!m_progress.isDone(m_run.lesson().id, step.id, static_cast<int>(i)))
            return plainText(step.tries[i].text);
    }
    if (step.tries.empty())
        return firstSentence(plainText(step.narration));
    return m_run.following()
               ? tr("Done! You have tried everything here. %1 opens the next step.").arg(keyText(m_nextKeys))
               : tr("Done! You have tried everything here.");
}

void SceneCard::refresh()
{
    m_title->setText(m_run.step().title);
    m_text->setText(sentence());
    setAccessibleName(labelled(m_title->text(), m_text->text()));
    place();
}

void SceneCard::place()
{
    const int width = std::min(cardWidth, m_scene.width() - 2 * cardGap);
    // Below the caption of the scene.
    const double top =
        m_scene.shown().caption.isEmpty() ? cardGap : freeArea(m_scene.shown(), QRectF(m_scene.rect())).top();
    const int wanted = std::min(width, sizeHint().width());
    const QRect box(cardGap, qRound(top), wanted, heightForWidth(wanted));
    if (box != geometry())
        setGeometry(box);
}

bool SceneCard::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == &m_scene && event->type() == QEvent::Resize)
        place();
    return QFrame::eventFilter(watched, event);
}

void SceneCard::showEvent(QShowEvent *event)
{
    QFrame::showEvent(event);
    place();
}

void SceneCard::paintEvent(QPaintEvent *)
{
    const Tokens &t = m_theme.tokens();
    const bool isPlain = m_theme.scheme() == Scheme::highContrast; // without transparency
    QColor fill = t.panel;
    fill.setAlphaF(isPlain ? 1.0F : static_cast<float>(cover));
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(t.line);
    painter.setBrush(fill);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), cardRadius, cardRadius);
}

}
