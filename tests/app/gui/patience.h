// Included before every Qt Test: Qt waits 5 s for a condition, which a sanitizer on a busy machine outlasts. A
// condition that comes true is seen at once whatever the limit; only a real failure takes this long.
#pragma once

#include <QTest>

#undef QTRY_VERIFY
#undef QTRY_COMPARE
#define QTRY_VERIFY(expression) QTRY_VERIFY_WITH_TIMEOUT((expression), 60000)
#define QTRY_COMPARE(actual, expected) QTRY_COMPARE_WITH_TIMEOUT((actual), expected, 60000)
