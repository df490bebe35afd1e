package faultline.gui;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.desktop.QuitResponse;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class SystemQuitTest {

    /** Records how the program answers the system. */
    private static final class Answer implements QuitResponse {

        private final List<String> calls;

        private Answer(List<String> calls) {
            this.calls = calls;
        }

        @Override
        public void performQuit() {
            calls.add("quit");
        }

        @Override
        public void cancelQuit() {
            calls.add("cancelled");
        }
    }

    @Test
    void theSystemDoesNotEndTheProgramButItsWindowIsClosed() {
        List<String> calls = new ArrayList<>();
        new SystemQuit(() -> calls.add("closed")).handleQuitRequestWith(null, new Answer(calls));
        assertEquals(List.of("cancelled", "closed"), calls);
    }
}
