# Copies the page's own modules beside the installed packages: cmake -DFROM=... -DTO=... -P copy_modules.cmake
file(GLOB modules "${FROM}/*.js" "${FROM}/build.mjs" "${FROM}/*.css" "${FROM}/template.html")
file(COPY ${modules} DESTINATION "${TO}")
