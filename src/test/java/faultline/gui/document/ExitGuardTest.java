package faultline.gui.document;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What keeps the program running. */
class ExitGuardTest {

    static Stream<Consumer<CompletableFuture<String>>> ends() {
        return Stream.of(
                work -> work.complete("written"),
                work -> work.completeExceptionally(new IOException("full")),
                work -> work.cancel(false));
    }

    @ParameterizedTest
    @MethodSource("ends")
    @Timeout(60)
    void theThreadLivesUntilTheTaskIsDoneHoweverItEnds(Consumer<CompletableFuture<String>> end)
            throws InterruptedException {
        CompletableFuture<String> work = new CompletableFuture<>();
        Thread guard = ExitGuard.keepAliveUntilDone(work);
        assertTrue(guard.isAlive());
        assertFalse(guard.isDaemon(), "a daemon would not keep the program from ending");
        end.accept(work);
        guard.join();
    }
}
