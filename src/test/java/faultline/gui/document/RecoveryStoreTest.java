package faultline.gui.document;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.scenario.Scenario;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Collections;
import java.util.concurrent.Callable;
import java.util.concurrent.CyclicBarrier;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RecoveryStoreTest {

    private static final int THREADS = 8;
    private static final int STORES = 40;

    @TempDir
    private Path folder;

    /** As if edits of a crashed process were taken over while those of this process are saved. */
    @Test
    void severalThreadsMaySaveTheFirstEditsAtTheSameTime() throws Exception {
        Scenario scenario = Scenario.load(Path.of("scenarios/collision-on-purpose.xml"));
        ExecutorService threads = Executors.newFixedThreadPool(THREADS);
        CyclicBarrier start = new CyclicBarrier(THREADS);
        try {
            for (int i = 0; i < STORES; i++) {
                RecoveryStore store = new RecoveryStore(folder.resolve(Integer.toString(i)));
                Callable<Void> save = () -> {
                    start.await();
                    store.save(null, scenario);
                    return null;
                };
                for (Future<Void> saved : threads.invokeAll(Collections.nCopies(THREADS, save))) {
                    saved.get();
                }
                assertEquals(3, countFiles(i), "the edits, their origin and the lock");
                store.delete();
                assertEquals(0, countFiles(i));
            }
        } finally {
            threads.shutdownNow();
        }
    }

    /** Without the lock, another window would offer the edits of this one. */
    @Test
    void theEditsOfARunningProcessAreLockedUntilTheyAreDeleted() throws Exception {
        RecoveryStore store = new RecoveryStore(folder);
        store.save(null, Scenario.load(Path.of("scenarios/collision-on-purpose.xml")));
        Path lock;
        try (var files = Files.newDirectoryStream(folder, "*.lock")) {
            lock = files.iterator().next();
        }
        try (FileChannel channel = FileChannel.open(lock, StandardOpenOption.WRITE)) {
            assertThrows(OverlappingFileLockException.class, channel::tryLock);
            store.delete();
            assertNotNull(channel.tryLock());
        }
        assertTrue(Files.notExists(lock));
    }

    private long countFiles(int store) throws IOException {
        try (var files = Files.list(folder.resolve(Integer.toString(store)))) {
            return files.count();
        }
    }
}
