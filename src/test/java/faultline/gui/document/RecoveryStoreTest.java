package faultline.gui.document;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.io.ForwardingFileSystemProvider;
import faultline.scenario.Scenario;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Files;
import java.nio.file.OpenOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileAttribute;
import java.time.Instant;
import java.util.Collections;
import java.util.Optional;
import java.util.Set;
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
                Path own = folder.resolve(Integer.toString(i));
                RecoveryStore store = new RecoveryStore(own);
                Callable<Void> save = () -> {
                    start.await();
                    store.save(null, null, scenario);
                    return null;
                };
                for (Future<Void> saved : threads.invokeAll(Collections.nCopies(THREADS, save))) {
                    saved.get();
                }
                assertEquals(4, countFiles(own), "the edits, their origin, their base and the lock");
                store.delete();
                assertEquals(0, countFiles(own));
            }
        } finally {
            threads.shutdownNow();
        }
    }

    /** Without the lock, another window would offer the edits of this one. */
    @Test
    void theEditsOfARunningProcessAreLockedUntilTheyAreDeleted() throws Exception {
        RecoveryStore store = new RecoveryStore(folder);
        store.save(null, null, Scenario.load(Path.of("scenarios/collision-on-purpose.xml")));
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

    /** A lock that nobody holds would show other windows that the edits were left by a crash. */
    @Test
    void whereFilesCannotBeLockedTheProcessIdShowsThatTheEditsAreInUse() throws Exception {
        FilesWithoutLocks files = new FilesWithoutLocks();
        Path unlockable = files.forwarding(folder);
        RecoveryStore store = new RecoveryStore(unlockable);
        Scenario scenario = Scenario.load(Path.of("scenarios/collision-on-purpose.xml"));
        store.save(null, null, scenario);
        store.save(null, null, scenario);
        assertEquals(1, files.attempts, "a lock file beside saved edits would show for a moment that nobody uses them");
        assertEquals(3, countFiles(folder), "the edits, their origin and their base");
        assertEquals(Optional.empty(), new RecoveryStore(unlockable, 0, Instant.EPOCH).findOrphan(Set.of()));
        store.delete();
        assertEquals(0, countFiles(folder));
    }

    /** As a network drive without a lock service: a closed channel refuses to lock with an {@link IOException}. */
    private static final class FilesWithoutLocks extends ForwardingFileSystemProvider {

        private int attempts;

        @Override
        public FileChannel newFileChannel(Path path, Set<? extends OpenOption> options, FileAttribute<?>... attributes)
                throws IOException {
            FileChannel channel = super.newFileChannel(path, options, attributes);
            if (path.toString().endsWith(".lock")) {
                channel.close();
                attempts++;
            }
            return channel;
        }
    }

    private static long countFiles(Path folder) throws IOException {
        try (var files = Files.list(folder)) {
            return files.count();
        }
    }
}
