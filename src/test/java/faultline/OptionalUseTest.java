package faultline;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.app.Main;
import java.lang.reflect.Executable;
import java.lang.reflect.Member;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** {@link Optional} is a type of results only, not of fields, record components and parameters. */
class OptionalUseTest {

    private static final Set<Class<?>> OPTIONALS =
            Set.of(Optional.class, OptionalDouble.class, OptionalInt.class, OptionalLong.class);

    private static Stream<Class<?>> classes() throws Exception {
        Path root = Path.of(
                Main.class.getProtectionDomain().getCodeSource().getLocation().toURI());
        List<Class<?>> classes = new ArrayList<>();
        try (Stream<Path> files = Files.walk(root.resolve("faultline"))) {
            for (Path file :
                    files.filter(path -> path.toString().endsWith(".class")).toList()) {
                String name = root.relativize(file)
                        .toString()
                        .replaceAll("[/\\\\]", ".")
                        .replaceAll("\\.class$", "");
                classes.add(Class.forName(name, false, OptionalUseTest.class.getClassLoader()));
            }
        }
        return classes.stream();
    }

    private static boolean takesOptional(Executable method) {
        return !method.isSynthetic() && Stream.of(method.getParameterTypes()).anyMatch(OPTIONALS::contains);
    }

    private static Stream<? extends Member> uses(Class<?> type) {
        Stream<? extends Member> fields = Stream.of(type.getDeclaredFields())
                .filter(field -> !field.isSynthetic() && OPTIONALS.contains(field.getType()));
        Stream<? extends Member> methods = Stream.of(type.getDeclaredMethods()).filter(OptionalUseTest::takesOptional);
        return Stream.concat(fields, methods);
    }

    @Test
    void optionalsAreResultsOnly() throws Exception {
        List<String> found = classes()
                .flatMap(OptionalUseTest::uses)
                .map(Object::toString)
                .sorted()
                .toList();
        assertEquals(List.of(), found);
    }
}
