#include "app/model/session/change_notifier.h"

#include <algorithm>

namespace app {

ChangeNotifier::Batch::~Batch()
{
    if (--m_changes.m_depth == 0)
        m_changes.flush();
}

void ChangeNotifier::announce(ChangeKinds kinds, std::int64_t firstFrame)
{
    const Batch batch(*this);
    m_pending.kinds |= kinds;
    m_pending.firstFrame = std::min(m_pending.firstFrame, firstFrame);
}

void ChangeNotifier::showMessage(const QString &sentence)
{
    const Batch batch(*this);
    m_sentences.push_back(sentence);
}

void ChangeNotifier::flush()
{
    ++m_depth; // so that changes announced by the preparation are part of this one
    ChangeKinds prepared;
    while (const ChangeKinds fresh = m_pending.kinds & ~prepared) {
        prepared |= fresh;
        if (m_prepare)
            m_prepare(fresh);
    }
    --m_depth;
    const Change change = std::exchange(m_pending, {});
    const QStringList sentences = std::exchange(m_sentences, {});
    if (change.kinds)
        emit changed(change);
    for (const QString &sentence : sentences)
        emit messageRequested(sentence);
}

}
