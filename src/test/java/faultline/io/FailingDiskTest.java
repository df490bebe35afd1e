package faultline.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.MappedByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.ReadableByteChannel;
import java.nio.channels.WritableByteChannel;
import java.nio.file.Files;
import java.nio.file.OpenOption;
import java.nio.file.Path;
import java.nio.file.attribute.FileAttribute;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A disk that fails while a long file is written. The system reports such a failure only once. */
@Timeout(60)
class FailingDiskTest {

    private static final byte[] LONG = new byte[9 << 20];

    private final CountDownLatch failed = new CountDownLatch(1);

    @TempDir
    private Path folder;

    /** Opens channels of which the first operation that forces content fails. */
    private final class FailingDisk extends ForwardingFileSystemProvider {
        @Override
        public FileChannel newFileChannel(Path path, Set<? extends OpenOption> options, FileAttribute<?>... attributes)
                throws IOException {
            return new FailingChannel(super.newFileChannel(path, options, attributes));
        }
    }

    private final class FailingChannel extends FileChannel {
        private final FileChannel real;

        FailingChannel(FileChannel real) {
            this.real = real;
        }

        @Override
        public void force(boolean metaData) throws IOException {
            if (failed.getCount() > 0) {
                failed.countDown();
                throw new IOException("Input/output error");
            }
        }

        @Override
        public int write(ByteBuffer source) throws IOException {
            return real.write(source);
        }

        @Override
        public FileLock tryLock(long position, long size, boolean shared) throws IOException {
            return real.tryLock(position, size, shared);
        }

        @Override
        protected void implCloseChannel() throws IOException {
            real.close();
        }

        @Override
        public int read(ByteBuffer target) {
            throw new UnsupportedOperationException();
        }

        @Override
        public long read(ByteBuffer[] targets, int offset, int length) {
            throw new UnsupportedOperationException();
        }

        @Override
        public long write(ByteBuffer[] sources, int offset, int length) {
            throw new UnsupportedOperationException();
        }

        @Override
        public long position() {
            throw new UnsupportedOperationException();
        }

        @Override
        public FileChannel position(long newPosition) {
            throw new UnsupportedOperationException();
        }

        @Override
        public long size() {
            throw new UnsupportedOperationException();
        }

        @Override
        public FileChannel truncate(long size) {
            throw new UnsupportedOperationException();
        }

        @Override
        public long transferTo(long position, long count, WritableByteChannel target) {
            throw new UnsupportedOperationException();
        }

        @Override
        public long transferFrom(ReadableByteChannel source, long position, long count) {
            throw new UnsupportedOperationException();
        }

        @Override
        public int read(ByteBuffer target, long position) {
            throw new UnsupportedOperationException();
        }

        @Override
        public int write(ByteBuffer source, long position) {
            throw new UnsupportedOperationException();
        }

        @Override
        public MappedByteBuffer map(MapMode mode, long position, long size) {
            throw new UnsupportedOperationException();
        }

        @Override
        public FileLock lock(long position, long size, boolean shared) {
            throw new UnsupportedOperationException();
        }
    }

    private AtomicFile replacement() throws IOException {
        return AtomicFile.create(new FailingDisk().forwarding(Files.writeString(folder.resolve("a.txt"), "old")));
    }

    private void assertUnchanged() throws IOException {
        assertEquals("old", Files.readString(folder.resolve("a.txt")));
        try (Stream<Path> files = Files.list(folder)) {
            assertEquals(List.of(folder.resolve("a.txt")), files.toList());
        }
    }

    @Test
    void aFileWhoseContentDidNotReachTheDiskDoesNotTakeItsPlace() throws Exception {
        try (AtomicFile out = replacement()) {
            out.stream().write(LONG);
            assertTrue(failed.await(30, TimeUnit.SECONDS));
            assertEquals(
                    folder.resolve("a.txt") + ": the file cannot be written completely",
                    assertThrows(IOException.class, out::commit).getMessage());
        }
        assertUnchanged();
    }

    /** A network or a quota may be full without any write that fails. */
    @Test
    void aShortFileThatDoesNotReachTheDiskIsNamed() throws Exception {
        try (AtomicFile out = replacement()) {
            out.stream().write(1);
            assertEquals(
                    folder.resolve("a.txt") + ": the file cannot be written completely",
                    assertThrows(MessageException.class, out::commit).getMessage());
        }
        assertUnchanged();
    }

    @Test
    void moreContentDoesNotHideThatEarlierContentDidNotReachTheDisk() throws Exception {
        try (AtomicFile out = replacement()) {
            out.stream().write(LONG);
            assertTrue(failed.await(30, TimeUnit.SECONDS));
            assertThrows(IOException.class, () -> {
                for (int i = 0; i < 5; i++) {
                    out.stream().write(LONG);
                }
                out.commit();
            });
        }
        assertUnchanged();
    }
}
