package faultline.external;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.Await;
import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

@EnabledOnOs(value = OS.LINUX, disabledReason = "reads /proc")
class DetachedProcessesTest {

    /** A process that might have started another one just before its end is not mistaken for one that still runs. */
    @Test
    void aProcessWhoseEndItsParentHasNotNoticedHasEnded() throws Exception {
        // The program that replaces the shell never asks for the end of the shell's child, which ends after that.
        String script = "exec 3<&0; (read line <&3) & exec sleep 1000";
        Process parent = new ProcessBuilder("sh", "-c", script).start();
        try {
            Await.until("the other program", () -> argumentsOf(parent).equals(List.of("1000")));
            Await.until("the child", () -> parent.children().count() == 1);
            ProcessHandle child = parent.children().findFirst().orElseThrow();
            assertFalse(DetachedProcesses.hasEnded(child));
            parent.getOutputStream().close();
            Await.until("its end", () -> DetachedProcesses.hasEnded(child));
            assertTrue(child.isAlive());
            assertFalse(DetachedProcesses.hasEnded(parent.toHandle()));
        } finally {
            parent.destroyForcibly().waitFor();
        }
        assertTrue(DetachedProcesses.hasEnded(parent.toHandle()));
    }

    private static List<String> argumentsOf(Process process) {
        return List.of(process.info().arguments().orElse(new String[0]));
    }

    /** The JDK's exception is of no subclass. */
    @Test
    void aListOfProcessesThatFailsIsAnErrorOfTheStart() {
        IOException refusal = assertThrows(
                IOException.class,
                () -> DetachedProcesses.listed(() -> {
                    throw new RuntimeException("Too many open files");
                }));
        assertEquals("Too many open files", refusal.getMessage());
    }
}
