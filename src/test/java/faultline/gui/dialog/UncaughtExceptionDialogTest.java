package faultline.gui.dialog;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class UncaughtExceptionDialogTest {

    @Test
    void errorsOfTheProgramAreReported() {
        assertTrue(UncaughtExceptionDialog.isReported(new AssertionError("of the program")));
    }

    @Test
    void preferencesThatTheJdkCannotWriteAreNoErrorOfTheProgram() {
        AssertionError fault = new AssertionError("no space left on device");
        fault.setStackTrace(new StackTraceElement[] {
            new StackTraceElement("java.util.prefs.XmlSupport", "writeDoc", "XmlSupport.java", 281),
            new StackTraceElement("java.util.TimerThread", "run", "Timer.java", 506)
        });
        assertFalse(UncaughtExceptionDialog.isReported(fault));
    }
}
