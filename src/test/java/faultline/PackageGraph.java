package faultline;

import faultline.app.Main;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.URISyntaxException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.spi.ToolProvider;

/** Which package of the program uses which, as {@code jdeps} finds it in the compiled classes. */
final class PackageGraph {

    private static final Pattern ARROW = Pattern.compile("^ *faultline\\.([\\w.]+) +-> faultline\\.([\\w.]+) ");

    private PackageGraph() {}

    /**
     * Returns the packages that each package uses, without the root package's name.
     *
     * @param classes the folder of the compiled classes
     */
    static SortedMap<String, Set<String>> read(Path classes) {
        ToolProvider jdeps = ToolProvider.findFirst("jdeps").orElseThrow();
        StringWriter out = new StringWriter();
        StringWriter err = new StringWriter();
        int status = jdeps.run(
                new PrintWriter(out),
                new PrintWriter(err),
                "-verbose:package",
                "--multi-release",
                "base",
                "" + classes);
        if (status != 0) {
            throw new IllegalStateException("jdeps failed: " + out + err);
        }
        SortedMap<String, Set<String>> uses = new TreeMap<>();
        out.toString().lines().flatMap(line -> ARROW.matcher(line).results()).forEach(arrow -> uses.computeIfAbsent(
                        arrow.group(1), name -> new TreeSet<>())
                .add(arrow.group(2)));
        return uses;
    }

    /** Returns the folder from which the program's classes are loaded. */
    static Path compiledClasses() {
        try {
            return Path.of(Main.class
                    .getProtectionDomain()
                    .getCodeSource()
                    .getLocation()
                    .toURI());
        } catch (URISyntaxException impossible) {
            throw new IllegalStateException(impossible);
        }
    }

    /**
     * Returns the packages of a cycle, each using the next and the last using the first.
     *
     * @param uses what each package uses
     * @return empty if there is no cycle
     */
    static List<String> cycle(Map<String, Set<String>> uses) {
        Set<String> acyclic = new LinkedHashSet<>();
        for (String start : uses.keySet()) {
            List<String> cycle = cycleFrom(start, uses, new ArrayDeque<>(), acyclic);
            if (!cycle.isEmpty()) {
                return cycle;
            }
        }
        return List.of();
    }

    private static List<String> cycleFrom(
            String name, Map<String, Set<String>> uses, Deque<String> path, Set<String> acyclic) {
        if (path.contains(name)) {
            List<String> cycle = new ArrayList<>(path);
            return cycle.subList(cycle.indexOf(name), cycle.size());
        }
        if (acyclic.contains(name)) {
            return List.of();
        }
        path.addLast(name);
        for (String used : uses.getOrDefault(name, Set.of())) {
            List<String> cycle = cycleFrom(used, uses, path, acyclic);
            if (!cycle.isEmpty()) {
                return cycle;
            }
        }
        path.removeLast();
        acyclic.add(name);
        return List.of();
    }
}
