import faultline.gui.dialog.AppIcon;
import faultline.io.Sha256;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.spi.ToolProvider;
import java.util.stream.Stream;
import javax.imageio.ImageIO;

/**
 * Makes packages with the JDK's own jlink and jpackage: a runtime of only the modules that are needed, an app image on
 * every system, and a .deb where dpkg is. Run by {@code mvn -Pdist package}; the results are in target/dist.
 *
 * <p>usage: java -Dpackage.email=EMAIL -Dpackage.homepage=URL -cp target/classes src/conf/dist/Package.java VERSION,
 * where the URL may be empty
 */
public final class Package {

    private static final String MODULES = "java.desktop,java.xml,java.prefs,java.logging";
    private static final String VENDOR = "Faultline maintainers";
    private static final Path DIST = Path.of("target/dist");
    private static final Path INPUT = DIST.resolve("input");
    private static final Path RUNTIME = DIST.resolve("runtime");
    private static final Path RESOURCES = Path.of("src/conf/dist/linux");
    /** A link of Markdown, as its text and its target, that names neither a scheme nor a place in the same page. */
    private static final Pattern RELATIVE_LINK = Pattern.compile("\\[([^\\]]*)]\\((?![a-z]+:|#)([^)\\s]+)\\)");

    private Package() {}

    public static void main(String[] args) throws Exception {
        String version = args[0];
        System.setProperty("java.awt.headless", "true");
        deleteTree(DIST);
        Files.createDirectories(INPUT);
        Files.copy(Path.of("target/faultline.jar"), INPUT.resolve("faultline.jar"));
        copyExamples(INPUT.resolve("doc/examples"));
        Path icon = INPUT.resolve("faultline.png");
        writeIcon(icon);
        copyShare(version);
        makeRuntime();
        List<String> common = List.of("--name", "faultline", "--dest", DIST.toString(), "--vendor", VENDOR);
        jpackage(
                common,
                List.of("--type", "app-image", "--input", INPUT.toString()),
                versionOption(version),
                List.of("--main-jar", "faultline.jar", "--main-class", "faultline.app.Main"),
                List.of("--java-options", "-Dfaultline.command=faultline"),
                List.of("--runtime-image", RUNTIME.toString()),
                isLinux() ? List.of("--icon", icon.toString()) : List.of(),
                isWindows() ? windowsOptions() : List.of());
        if (isLinux() && isOnPath("dpkg-deb") && isOnPath("fakeroot")) {
            makeDebianPackage(common, version);
        }
        writeChecksums();
        // The app image and the package have copies.
        deleteTree(INPUT);
        deleteTree(RUNTIME);
    }

    private static void makeDebianPackage(List<String> common, String version) throws Exception {
        String homepage = System.getProperty("package.homepage");
        jpackage(
                common,
                List.of("--type", "deb", "--app-version", version),
                List.of("--app-image", DIST.resolve("faultline").toString()),
                List.of("--resource-dir", RESOURCES.toString(), "--linux-package-name", "faultline"),
                List.of("--linux-app-category", "science"),
                List.of("--linux-deb-maintainer", System.getProperty("package.email")),
                // Java loads it when it first measures a text, and it brings a font; jpackage does not see this.
                List.of("--linux-package-deps", "libfontconfig1"),
                List.of("--description", "simulator of a wall-following robot whose infrared sensors fail"),
                homepage.isEmpty() ? List.of() : List.of("--about-url", homepage));
        try (Stream<Path> made = Files.list(DIST)) {
            removePostrm(made.filter(file -> file.toString().endsWith(".deb"))
                    .findFirst()
                    .orElseThrow());
        }
    }

    /**
     * Removes the script that jpackage adds for what is to be done after a removal. There is nothing to be done, and
     * because of the script dpkg keeps the package in its database until it is purged. The other files, which take long
     * to compress, are copied as they are.
     */
    private static void removePostrm(Path deb) throws IOException, InterruptedException {
        Path root = DIST.resolve("control");
        Files.createDirectory(root);
        Path control = DIST.resolve("control.deb");
        execute("dpkg-deb", "--control", deb.toString(), root.resolve("DEBIAN").toString());
        Files.deleteIfExists(root.resolve("DEBIAN/postrm"));
        execute("dpkg-deb", "--root-owner-group", "--build", root.toString(), control.toString());
        byte[] old = Files.readAllBytes(deb);
        byte[] changed = Files.readAllBytes(control);
        try (OutputStream out = Files.newOutputStream(deb)) {
            out.write(changed, 0, dataStart(changed));
            out.write(old, dataStart(old), old.length - dataStart(old));
        }
        deleteTree(root);
        Files.delete(control);
    }

    /** Returns where the installed files begin in a package, an ar archive whose members before them are for dpkg. */
    private static int dataStart(byte[] deb) {
        int start = "!<arch>\n".length();
        while (!new String(deb, start, 16, StandardCharsets.US_ASCII).startsWith("data.tar")) {
            int size = Integer.parseInt(new String(deb, start + 48, 10, StandardCharsets.US_ASCII).strip());
            // The header of a member has 60 bytes; each begins at an even place.
            start += 60 + size + size % 2;
        }
        return start;
    }

    private static void execute(String... command) throws IOException, InterruptedException {
        Process process = new ProcessBuilder(command).inheritIO().start();
        require(process.waitFor() == 0, command[0] + " failed");
    }

    /** On macOS, jpackage refuses a version that begins with 0; an app image without a version is 1.0 there. */
    private static List<String> versionOption(String version) {
        return isMac() && version.startsWith("0.") ? List.of() : List.of("--app-version", version);
    }

    /**
     * A program of Windows either writes to the console or opens without one, so there are two, as java and javaw are.
     */
    private static List<String> windowsOptions() throws IOException {
        Path launcher = DIST.resolve("faultlinew.properties");
        Files.write(launcher, List.of("win-console=false", "arguments=--window"));
        return List.of("--win-console", "--add-launcher", "faultlinew=" + launcher);
    }

    /** Classes are not compressed, because unpacking them makes a start slower. */
    private static void makeRuntime() throws IOException, InterruptedException {
        run(
                "jlink",
                List.of(
                        "--add-modules",
                        MODULES,
                        "--no-header-files",
                        "--no-man-pages",
                        "--compress=0",
                        "--output",
                        RUNTIME.toString()));
        // jlink leaves out the archive of the JDK's own classes, without which a start takes half as long again.
        String java = RUNTIME.resolve("bin")
                .resolve(isWindows() ? "java.exe" : "java")
                .toString();
        execute(java, "-Xshare:dump", "-Xlog:disable");
    }

    /**
     * Copies what a user needs to write a first controller: the Python client, the follower of the page, and rooms,
     * with the extension by which a desktop opens them.
     */
    private static void copyExamples(Path target) throws IOException {
        copyFiles(Path.of("docs/examples/python"), ".py", target, ".py");
        copyFiles(Path.of("scenarios"), ".xml", target.resolve("scenarios"), ".faultline");
        String page = Files.readString(Path.of("docs/controllers.md"));
        Files.writeString(target.resolveSibling("controllers.md"), withInstalledLinks(page, target.getParent()));
    }

    /**
     * Returns a page of the documentation whose relative links lead to files in a folder, in which the Python files are
     * directly among the examples. A link to a page that the package does not have becomes its text.
     */
    private static String withInstalledLinks(String page, Path folder) {
        return RELATIVE_LINK.matcher(page).replaceAll(link -> {
            String file = link.group(2).replace("examples/python/", "examples/");
            boolean installed = Files.exists(folder.resolve(file));
            return Matcher.quoteReplacement(
                    installed ? "[" + link.group(1) + "](" + file + ")" : link.group(1));
        });
    }

    private static void copyFiles(Path folder, String ending, Path target, String newEnding) throws IOException {
        Files.createDirectories(target);
        try (Stream<Path> files = Files.list(folder)) {
            for (Path file :
                    files.filter(each -> each.toString().endsWith(ending)).toList()) {
                String name = file.getFileName().toString();
                Files.copy(file, target.resolve(name.substring(0, name.length() - ending.length()) + newEnding));
            }
        }
    }

    private static void writeIcon(Path file) throws IOException {
        BufferedImage icon = AppIcon.createImage(256);
        require(ImageIO.write(icon, "png", file.toFile()), "no PNG writer");
    }

    /** Copies what the Debian package puts in its places when it is installed. */
    private static void copyShare(String version) throws IOException {
        for (String name : List.of("faultline.desktop", "faultline-mime.xml")) {
            Files.copy(RESOURCES.resolve("share").resolve(name), INPUT.resolve(name));
        }
        String manual = Files.readString(RESOURCES.resolve("share/faultline.1"));
        Files.writeString(INPUT.resolve("faultline.1"), manual.replace("VERSION", version));
    }

    private static void jpackage(List<String> first, List<?>... more) {
        List<String> arguments = new ArrayList<>(first);
        Stream.of(more).flatMap(List::stream).map(String.class::cast).forEach(arguments::add);
        run("jpackage", arguments);
    }

    private static void run(String tool, List<String> arguments) {
        ToolProvider provider =
                ToolProvider.findFirst(tool).orElseThrow(() -> new IllegalStateException("this JDK has no " + tool));
        require(provider.run(System.out, System.err, arguments.toArray(new String[0])) == 0, tool + " failed");
    }

    /** One line for each file that is given to users, in the manner of sha256sum. */
    private static void writeChecksums() throws Exception {
        List<String> lines = new ArrayList<>();
        List<Path> files = new ArrayList<>();
        try (Stream<Path> made = Stream.concat(Files.list(DIST), Files.list(Path.of("target")))) {
            made.filter(Files::isRegularFile)
                    .filter(file -> file.toString().matches(".*\\.(deb|jar|msi|exe|dmg|pkg)"))
                    .sorted(Comparator.comparing(Path::getFileName))
                    .forEach(files::add);
        }
        for (Path file : files) {
            lines.add(Sha256.hex(Files.readAllBytes(file)) + "  " + file.getFileName());
            Path copy = DIST.resolve(file.getFileName());
            if (!file.equals(copy)) {
                Files.copy(file, copy, StandardCopyOption.REPLACE_EXISTING);
            }
        }
        Files.write(DIST.resolve("SHA256SUMS"), lines);
    }

    private static boolean isLinux() {
        return os().contains("linux");
    }

    private static boolean isMac() {
        return os().startsWith("mac");
    }

    private static boolean isWindows() {
        return os().contains("windows");
    }

    private static String os() {
        return System.getProperty("os.name").toLowerCase(Locale.ROOT);
    }

    private static boolean isOnPath(String program) {
        return Stream.of(System.getenv("PATH").split(":"))
                .anyMatch(folder -> Files.isExecutable(Path.of(folder, program)));
    }

    private static void require(boolean condition, String problem) {
        if (!condition) {
            throw new IllegalStateException(problem);
        }
    }

    private static void deleteTree(Path root) throws IOException {
        if (Files.notExists(root)) {
            return;
        }
        try (Stream<Path> files = Files.walk(root)) {
            for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                Files.delete(file);
            }
        }
    }
}
