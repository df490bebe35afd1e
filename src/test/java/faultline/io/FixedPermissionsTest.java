package faultline.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Proxy;
import java.nio.file.FileSystemException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.FileAttributeView;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A file system that does not change permissions, such as a mounted one of another system. */
class FixedPermissionsTest {

    @TempDir
    private Path folder;

    /** Refuses to change permissions. */
    private static final class FixedPermissions extends ForwardingFileSystemProvider {
        @Override
        public <V extends FileAttributeView> V getFileAttributeView(Path path, Class<V> type, LinkOption... options) {
            V real = super.getFileAttributeView(path, type, options);
            InvocationHandler refusal = (view, method, arguments) -> {
                if (method.getName().equals("setPermissions")) {
                    throw new FileSystemException(path.toString(), null, "Operation not permitted");
                }
                return method.invoke(real, arguments);
            };
            return type.cast(Proxy.newProxyInstance(
                    FixedPermissionsTest.class.getClassLoader(), new Class<?>[] {type}, refusal));
        }
    }

    @BeforeEach
    void assumePermissions() {
        assumeTrue(FileSystems.getDefault().supportedFileAttributeViews().contains("posix"));
    }

    private void write(Path file) throws IOException {
        AtomicFile.write(new FixedPermissions().forwarding(file), new byte[] {'a'});
    }

    @Test
    void aNewFileIsWritten() throws IOException {
        Path file = folder.resolve("new.txt");
        write(file);
        assertEquals("a", Files.readString(file));
    }

    @Test
    void aReplacedFileIsWrittenAndIsNotReadableForMorePeople() throws IOException {
        Path file = Files.writeString(folder.resolve("old.txt"), "old");
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-------"));
        write(file);
        assertEquals("a", Files.readString(file));
        assertEquals("rw-------", PosixFilePermissions.toString(Files.getPosixFilePermissions(file)));
    }
}
