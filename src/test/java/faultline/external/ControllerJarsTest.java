package faultline.external;

import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import org.junit.jupiter.api.Test;

class ControllerJarsTest {

    @Test
    void aClassLoaderIsSetOnlyDuringAnAction() {
        ClassLoader before = Thread.currentThread().getContextClassLoader();
        assertInstanceOf(JarClassLoader.class, ControllerJars.callWith(List.of(), () -> Thread.currentThread()
                .getContextClassLoader()));
        assertSame(before, Thread.currentThread().getContextClassLoader());
        assertThrows(
                IllegalStateException.class,
                () -> ControllerJars.callWith(List.of(), () -> {
                    throw new IllegalStateException();
                }));
        assertSame(before, Thread.currentThread().getContextClassLoader());
    }
}
