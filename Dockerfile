# The daemon in a container, as an unprivileged user, with one volume.
#
#   docker build -t selvage .
#   docker run --rm --read-only --cap-drop ALL -v selvage:/var/lib/selvage \
#     -v "$PWD/token:/run/secrets/selvage-token:ro" -p 127.0.0.1:7171:7171 selvage
#
# The steps are those of packaging/build.sh, which the packaging test runs too.
FROM debian:12-slim AS build
WORKDIR /selvage
COPY packages.txt ./
COPY packaging/ packaging/
RUN packaging/build.sh build-packages
COPY . .
RUN packaging/build.sh build /build && packaging/build.sh install /build /installed

FROM debian:12-slim
COPY packaging/build.sh packaging/packages-run.txt /packaging/
RUN /packaging/build.sh run-packages && rm -r /packaging \
  && install -d -o 10001 -g 10001 -m 700 /var/lib/selvage
COPY --from=build /installed/ /usr/
COPY packaging/container.toml /etc/selvage/selvaged.toml
USER 10001:10001
VOLUME /var/lib/selvage
EXPOSE 7171
STOPSIGNAL SIGTERM
HEALTHCHECK --interval=10s --timeout=5s --start-period=10s CMD ["/usr/libexec/selvage/healthcheck.sh", "7172"]
ENTRYPOINT ["/usr/bin/selvaged", "--config", "/etc/selvage/selvaged.toml"]
