package faultline.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.JavaProcess;
import java.util.List;
import org.junit.jupiter.api.Test;

class ShutdownHooksTest {

    /** A program that adds and removes a hook while it is ending. */
    static final class EndingProgram {
        private EndingProgram() {}

        public static void main(String[] arguments) {
            Thread late = new Thread(() -> System.out.print("late "));
            Runtime.getRuntime().addShutdownHook(new Thread(() -> {
                System.out.print("added: " + ShutdownHooks.add(late));
                ShutdownHooks.remove(late);
            }));
        }
    }

    @Test
    void aHookIsAdded() {
        Thread hook = new Thread(() -> {});
        assertTrue(ShutdownHooks.add(hook));
        assertTrue(Runtime.getRuntime().removeShutdownHook(hook), "was not added");
    }

    @Test
    void aHookIsRemoved() {
        Thread hook = new Thread(() -> {});
        ShutdownHooks.add(hook);
        ShutdownHooks.remove(hook);
        assertFalse(Runtime.getRuntime().removeShutdownHook(hook), "was not removed");
    }

    @Test
    void nothingIsAddedWhileTheProcessEnds() throws Exception {
        Process ending = JavaProcess.builder(EndingProgram.class.getName(), List.of())
                .redirectErrorStream(true)
                .start();
        assertEquals("added: false", JavaProcess.output(ending));
        assertEquals(0, ending.waitFor());
    }
}
