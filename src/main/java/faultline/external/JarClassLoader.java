package faultline.external;

import faultline.control.ControllerProvider;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLConnection;
import java.net.URLStreamHandler;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemNotFoundException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.security.CodeSigner;
import java.security.CodeSource;
import java.security.ProtectionDomain;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Enumeration;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.jar.Attributes;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import java.util.jar.Manifest;
import java.util.zip.ZipFile;

/**
 * Loads classes and resources from copies of jars in memory. The jars are closed when they have been read, so they can
 * be replaced while their classes are in use. A class or resource of a jar replaces the one of the class path of the
 * same name, except the classes of this program and of the JDK, which the jar shares with the program. Where all
 * resources of a name are asked for, those of the class path come first.
 */
final class JarClassLoader extends ClassLoader {

    private static final String PROGRAM_FOLDER = "faultline/";
    private static final String SERVICE = "META-INF/services/" + ControllerProvider.class.getName();

    /** A file in a jar. */
    private record Content(ProtectionDomain jar, URL url, byte[] bytes) {}

    private final Map<String, List<Content>> contents = new HashMap<>();

    /**
     * Reads jars, and the readable ones that their manifests name as their class path.
     *
     * @param jars the jar files, in the order in which they are searched
     * @param parent the class loader of what the jars do not have, and of the program
     * @throws ControllerStartException if one of these jars cannot be read or names no controller
     */
    JarClassLoader(List<Path> jars, ClassLoader parent) {
        super(parent);
        Set<Path> done = new HashSet<>();
        for (Path jar : jars) {
            if (done.contains(jar.toAbsolutePath().normalize())) {
                continue;
            }
            int named = contentsOf(SERVICE).size();
            try {
                readWithClassPath(jar.toAbsolutePath().normalize(), done);
            } catch (NoSuchFileException missing) {
                throw new ControllerStartException(ControllerProblem.NO_JAR.with(jar), missing);
            } catch (IOException | UncheckedIOException | SecurityException broken) {
                throw new ControllerStartException(
                        ControllerProblem.JAR_UNREADABLE.with(jar, String.valueOf(broken.getMessage())), broken);
            }
            List<Content> services = contentsOf(SERVICE);
            if (services.size() == named) {
                throw new ControllerStartException(ControllerProblem.NO_SERVICE.with(jar, SERVICE), null);
            }
            if (services.stream().skip(named).noneMatch(JarClassLoader::namesClass)) {
                throw new ControllerStartException(ControllerProblem.NO_NAMED_CLASS.with(jar, SERVICE), null);
            }
        }
    }

    private List<Content> contentsOf(String name) {
        return contents.getOrDefault(name, List.of());
    }

    /** Returns whether a file of a service names a class that is not of the JDK, as the service loader reads it. */
    private static boolean namesClass(Content service) {
        return new String(service.bytes, StandardCharsets.UTF_8)
                .lines()
                .map(line -> line.replaceFirst("#.*", "").trim())
                .anyMatch(name -> !name.isEmpty() && !isOfJdk(classFile(name)));
    }

    private static boolean isOfJdk(String file) {
        return ClassLoader.getPlatformClassLoader().getResource(file) != null;
    }

    /** Reads a jar and those of its class path, unless it is among those that have been read. */
    private void readWithClassPath(Path jar, Set<Path> done) throws IOException {
        if (done.contains(jar)) {
            return;
        }
        List<String> classPath = read(jar);
        done.add(jar);
        for (String place : classPath) {
            try {
                readWithClassPath(Path.of(jar.toUri().resolve(place)).normalize(), done);
            } catch (IOException | UncheckedIOException | SecurityException unreadable) {
                // A class path may name files that are not needed.
            } catch (IllegalArgumentException | FileSystemNotFoundException noPath) {
                // It may also name what is not a file.
            }
        }
    }

    /** Reads a jar and returns its class path. */
    private List<String> read(Path jar) throws IOException {
        URL location = jar.toUri().toURL();
        ProtectionDomain domain = new ProtectionDomain(new CodeSource(location, (CodeSigner[]) null), null);
        try (JarFile file = new JarFile(jar.toFile(), true, ZipFile.OPEN_READ, Runtime.version())) {
            for (JarEntry entry : file.versionedStream().toList()) {
                try (InputStream in = file.getInputStream(entry)) {
                    byte[] bytes = in.readAllBytes();
                    contents.computeIfAbsent(entry.getName(), name -> new ArrayList<>())
                            .add(new Content(domain, url(location, entry.getName(), bytes), bytes));
                }
            }
            Manifest manifest = file.getManifest();
            String classPath =
                    manifest == null ? null : manifest.getMainAttributes().getValue(Attributes.Name.CLASS_PATH);
            return classPath == null ? List.of() : List.of(classPath.trim().split(" +"));
        }
    }

    /** Returns an address that reads the copy. */
    private static URL url(URL jar, String name, byte[] bytes) throws MalformedURLException {
        return new URL(null, "jar:" + jar + "!/" + name, new URLStreamHandler() {
            @Override
            protected URLConnection openConnection(URL url) {
                return new URLConnection(url) {
                    @Override
                    public void connect() {
                        // The copy is in memory.
                    }

                    @Override
                    public InputStream getInputStream() {
                        return new ByteArrayInputStream(bytes);
                    }
                };
            }
        });
    }

    @Override
    protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
        String file = classFile(name);
        if (!isOwn(file) || isOfJdk(file)) {
            return super.loadClass(name, resolve);
        }
        synchronized (getClassLoadingLock(name)) {
            Class<?> loaded = findLoadedClass(name);
            return loaded == null ? findClass(name) : loaded;
        }
    }

    private static String classFile(String className) {
        return className.replace('.', '/') + ".class";
    }

    /** Whether a file is that of a jar, also if the class path has one of the same name. */
    private boolean isOwn(String file) {
        return !file.startsWith(PROGRAM_FOLDER) && contents.containsKey(file);
    }

    @Override
    public URL getResource(String name) {
        return isOwn(name) ? findResource(name) : super.getResource(name);
    }

    @Override
    protected Class<?> findClass(String name) throws ClassNotFoundException {
        List<Content> found = contents.get(classFile(name));
        if (found == null) {
            throw new ClassNotFoundException(name);
        }
        Content first = found.get(0);
        return defineClass(name, first.bytes, 0, first.bytes.length, first.jar);
    }

    @Override
    protected URL findResource(String name) {
        return contents.containsKey(name) ? contents.get(name).get(0).url : null;
    }

    @Override
    protected Enumeration<URL> findResources(String name) {
        return Collections.enumeration(
                contentsOf(name).stream().map(Content::url).toList());
    }
}
