#include "app/ui/window/attempt.h"

#include "app/model/refusal.h"
#include "app/model/sentences.h"
#include "app/ui/window/notice.h"
#include "sim/base/error.h"

#include <QCoreApplication>

#include <new>

namespace app {

bool attempt(Notice &notice, const QString &failure, const std::function<void()> &deed)
{
    QString why;
    try {
        deed();
        return true;
    } catch (const Refusal &refusal) {
        why = refusal.sentence();
    } catch (const sim::Error &error) {
        why = sentenceFor(error);
    } catch (const std::bad_alloc &) {
        why = QCoreApplication::translate("Attempt", "There is not enough memory for it.");
    }
    notice.say(failure.arg(why));
    return false;
}

}
